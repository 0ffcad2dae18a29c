// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

namespace tapeline {

/// While it lives, OpenCASCADE's messages go nowhere instead of to standard output. Messages and the settings of its
/// readers and writers belong to the whole process, so only one thread at a time has one; others wait.
class QuietOcct {
public:
    QuietOcct();
    ~QuietOcct();
    QuietOcct(const QuietOcct&) = delete;
    QuietOcct& operator=(const QuietOcct&) = delete;

private:
    struct Printers;
    std::unique_ptr<Printers> printers_;
};

} // namespace tapeline
