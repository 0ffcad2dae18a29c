// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/error.h"

#include <exception>
#include <new>

namespace tapeline {

/// Runs a step that returns a Result and turns an exception, which is a fault of ours or a lack of memory, into a
/// failure.
template <class Step>
auto guarded(const Step& step) -> decltype(step())
{
    try {
        return step();
    } catch (const std::bad_alloc&) {
        return fail(ErrorKind::rejected, "out of memory; take a coarser mesh or a larger --linear-deflection");
    } catch (const std::exception& error) {
        return fail(ErrorKind::rejected, std::string("internal failure: ") + error.what());
    }
}

} // namespace tapeline
