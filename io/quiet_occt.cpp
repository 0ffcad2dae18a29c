// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/quiet_occt.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <iostream>
#include <mutex>

namespace tapeline {

namespace {

std::recursive_mutex& one_thread_at_a_time()
{
    static std::recursive_mutex mutex;
    return mutex;
}

} // namespace

struct QuietOcct::Printers {
    std::lock_guard<std::recursive_mutex> lock{one_thread_at_a_time()};
    Message_SequenceOfPrinters kept;
    std::streambuf* standard_output = nullptr;
};

QuietOcct::QuietOcct() : printers_(std::make_unique<Printers>())
{
    printers_->kept = Message::DefaultMessenger()->Printers();
    Message::DefaultMessenger()->ChangePrinters().Clear();
    // The BREP reader writes past the messenger, straight to std::cout, where a program's results go.
    printers_->standard_output = std::cout.rdbuf(nullptr);
}

QuietOcct::~QuietOcct()
{
    std::cout.rdbuf(printers_->standard_output);
    Message::DefaultMessenger()->ChangePrinters() = printers_->kept;
}

} // namespace tapeline
