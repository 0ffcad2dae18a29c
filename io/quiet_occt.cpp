// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/quiet_occt.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <iostream>

namespace tapeline
{

struct QuietOcct::Printers {
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
