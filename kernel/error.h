// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace tapeline {

/// What went wrong, in the classes that a caller can act on. Each has its own exit code (`exit_code`).
enum class ErrorKind {
    usage,         ///< the call itself is wrong: unknown option, value outside its range
    unreadable,    ///< a file cannot be opened, parsed or written
    rejected,      ///< the input was read but the method cannot work on it
    not_converged, ///< the solver did not reach its tolerance, or the answer is ambiguous
    quality_gate,  ///< a result was made but misses a limit that the caller asked for
    cancelled      ///< the caller cancelled through `Progress`
};

/// One failure: its class and one sentence for a person (what, where, and what to do about it).
struct Error {
    ErrorKind kind = ErrorKind::rejected;
    std::string message;
};

/// Value or `Error`; every public function that can fail returns one.
template <class T>
using Result = tl::expected<T, Error>;

/// Shorthand to return a failure from a function whose return type is some `Result`.
inline tl::unexpected<Error> fail(ErrorKind kind, std::string message)
{
    return tl::unexpected<Error>(Error{kind, std::move(message)});
}

/// Process exit code of an error class: 1 usage, 2 unreadable, 3 rejected, 4 not converged, 5 gate, 130 cancelled.
constexpr int exit_code(ErrorKind kind)
{
    switch (kind) {
    case ErrorKind::usage:
        return 1;
    case ErrorKind::unreadable:
        return 2;
    case ErrorKind::rejected:
        return 3;
    case ErrorKind::not_converged:
        return 4;
    case ErrorKind::quality_gate:
        return 5;
    case ErrorKind::cancelled:
        return 130;
    }
    return 1;
}

} // namespace tapeline
