// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

namespace tapeline
{

/// While it lives, OpenCASCADE's messages go nowhere instead of to standard output.
class QuietOcct
{
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
