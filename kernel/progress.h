// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string_view>
#include <utility>

namespace tapeline {

/// Progress and cancellation in one handle, cheap to copy and to divide.
/// Contract: fractions given to the callback never decrease within a run and lie in [0, 1]; the callback returns
/// false to cancel; it is only ever called from the thread that called into Tapeline; a function that was cancelled
/// returns ErrorKind::cancelled and leaves nothing behind.
class Progress {
public:
    using Callback = std::function<bool(double fraction, std::string_view stage)>;

    Progress() = default;
    explicit Progress(Callback callback) : callback_(std::move(callback)) {}

    /// Reports fraction ∈ [0, 1] of this handle's share; false means: stop now.
    bool report(double fraction, std::string_view stage) const
    {
        return !callback_ || callback_(from_ + fraction * (to_ - from_), stage);
    }

    /// A handle for the part [from, to] of this one.
    Progress part(double from, double to) const
    {
        Progress p(*this);
        p.from_ = from_ + from * (to_ - from_);
        p.to_ = from_ + to * (to_ - from_);
        return p;
    }

private:
    Callback callback_;
    double from_ = 0;
    double to_ = 1;
};

} // namespace tapeline
