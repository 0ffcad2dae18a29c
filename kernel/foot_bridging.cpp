// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/foot_bridging.h"

#include <algorithm>

namespace tapeline {

namespace {

constexpr double largest_spread = 2;
constexpr double smallest_spread = 0.2;
constexpr double largest_bridged = 1.6;
constexpr double smallest_bridged = 0.6;

struct Window {
    int from = 0, to = 0;
};

/// Average spread of a window against that of the whole row.
double spread(const StationRow& row, const Window& w)
{
    const double whole = (row.station.back() - row.station.front()) / (row.along.back() - row.along.front());
    return (row.station[w.to] - row.station[w.from]) / (row.along[w.to] - row.along[w.from]) / whole;
}

/// Stretches between two known stations that hold unknown ones or are spread too unevenly.
std::vector<Window> bad_windows(const StationRow& row)
{
    std::vector<Window> windows;
    const int n = static_cast<int>(row.station.size());
    for (int i = 0; i + 1 < n;) {
        int j = i + 1;
        while (j + 1 < n && row.bad[j]) {
            ++j;
        }
        const double s = spread(row, {i, j});
        if (j > i + 1 || s > largest_spread || s < smallest_spread) {
            windows.push_back({i, j});
        }
        i = j;
    }
    return windows;
}

void widen(const StationRow& row, Window& w)
{
    const int n = static_cast<int>(row.station.size());
    const auto uneven = [&] {
        const double s = spread(row, w);
        return s > largest_bridged || s < smallest_bridged;
    };
    while ((uneven() || row.bad[w.from] || row.bad[w.to]) && (w.from > 0 || w.to + 1 < n)) {
        w.from = std::max(0, w.from - 1);
        w.to = std::min(n - 1, w.to + 1);
    }
}

} // namespace

tl::expected<std::vector<bool>, int> bridge(StationRow& row)
{
    std::vector<bool> replaced(row.station.size(), false);
    std::vector<Window> windows = bad_windows(row);
    if (windows.empty()) {
        return replaced;
    }
    const int first_trouble = windows.front().from;
    for (bool merged = true; merged;) {
        for (Window& w : windows) {
            widen(row, w);
        }
        merged = false;
        for (size_t i = 0; i + 1 < windows.size(); ++i) {
            if (windows[i + 1].from < windows[i].to) {
                windows[i] = {std::min(windows[i].from, windows[i + 1].from),
                              std::max(windows[i].to, windows[i + 1].to)};
                windows.erase(windows.begin() + static_cast<long>(i) + 1);
                merged = true;
                break;
            }
        }
    }
    double bridged_length = 0;
    for (const Window& w : windows) {
        bridged_length += row.along[w.to] - row.along[w.from];
        const double s0 = row.station[w.from], s1 = row.station[w.to];
        for (int k = w.from + 1; k < w.to; ++k) {
            row.station[k] =
                s0 + (s1 - s0) * (row.along[k] - row.along[w.from]) / (row.along[w.to] - row.along[w.from]);
            replaced[k] = true;
        }
    }
    if (bridged_length > 0.5 * (row.along.back() - row.along.front())) {
        return tl::unexpected(first_trouble);
    }
    for (size_t k = 0; k + 1 < row.station.size(); ++k) {
        if (!(row.station[k + 1] > row.station[k])) {
            return tl::unexpected(static_cast<int>(k));
        }
    }
    return replaced;
}

int farthest_from(const std::vector<bool>& bad)
{
    const int n = static_cast<int>(bad.size());
    std::vector<int> distance(n, n);
    for (int pass = 0; pass < 2; ++pass) {
        for (int k = 0; k < 2 * n; ++k) {
            const int i = pass == 0 ? k % n : (2 * n - 1 - k) % n;
            const int before = pass == 0 ? (i + n - 1) % n : (i + 1) % n;
            distance[i] = bad[i] ? 0 : std::min(distance[i], distance[before] + 1);
        }
    }
    return static_cast<int>(std::ranges::max_element(distance) - distance.begin());
}

} // namespace tapeline
