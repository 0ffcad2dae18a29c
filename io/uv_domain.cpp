// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/uv_domain.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tapeline {

UvDomain::UvDomain(std::vector<Segment> segments) : segments_(std::move(segments))
{
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Segment& segment : segments_) {
        low = std::min({low, segment[0].y(), segment[1].y()});
        high = std::max({high, segment[0].y(), segment[1].y()});
    }
    const int count = std::clamp(static_cast<int>(segments_.size()) / 4, 1, 1024);
    first_v_ = segments_.empty() ? 0 : low;
    row_height_ = high > low ? (high - low) / count : 1;
    rows_.resize(count);
    for (size_t i = 0; i < segments_.size(); ++i) {
        const int a = row_of(segments_[i][0].y()), b = row_of(segments_[i][1].y());
        for (int row = std::min(a, b); row <= std::max(a, b); ++row) {
            rows_[row].push_back(static_cast<int>(i));
        }
    }
}

int UvDomain::row_of(double v) const
{
    const double row = std::floor((v - first_v_) / row_height_);
    return static_cast<int>(std::clamp(row, 0.0, static_cast<double>(rows_.size()) - 1));
}

bool UvDomain::contains(const Eigen::Vector2d& uv) const
{
    if (segments_.empty()) {
        return true;
    }
    bool inside = false;
    for (const int i : rows_[row_of(uv.y())]) {
        const auto& [a, b] = segments_[i];
        if ((a.y() > uv.y()) != (b.y() > uv.y())) {
            const double u = a.x() + (b.x() - a.x()) * (uv.y() - a.y()) / (b.y() - a.y());
            inside ^= u > uv.x();
        }
    }
    return inside;
}

} // namespace tapeline
