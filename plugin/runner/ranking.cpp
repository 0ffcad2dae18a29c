// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/comparison.h"
#include "plugin/runner/numbers.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <tuple>
#include <utility>

namespace tapeline {

namespace {

/// Bulges that differ by less than this share of the slide are no difference.
constexpr double equal_bulge = 0.001;

int new_inflections(const SectionMeasure& m) { return std::max(0, m.inflections_after - m.inflections_before); }

bool keeps_limits(const MethodRun& run)
{
    return std::ranges::all_of(run.gates, [](const GateResult& gate) { return gate.passed; });
}

int new_inflections(const QualityReport& q)
{
    return new_inflections(q.compressed_sections) + new_inflections(q.tension_sections);
}

/// Of the runs with fewest flipped triangles.
double least_bulge(const std::vector<MethodRun>& runs)
{
    std::pair least(std::numeric_limits<int>::max(), std::numeric_limits<double>::infinity());
    for (const MethodRun& run : runs) {
        if (run.sound() && run.measures.has_compressed) {
            const QualityReport& q = run.measures.quality;
            least = std::min(least, std::pair(q.flipped, std::abs(q.bulge_max_mm)));
        }
    }
    return least.second;
}

std::string size_text(double mm) { return short_number(mm) + " mm"; }

std::string count_text(int count, const char* what)
{
    return fmt::format("{} {}{}", count == 0 ? "no" : std::to_string(count), what, count == 1 ? "" : "s");
}

/// Flips and inflections, as far as they differ from the other's; nothing where they do not.
std::string blemishes(const MethodRun& run, const MethodRun* other)
{
    const QualityReport& q = run.measures.quality;
    std::vector<std::string> parts;
    if (other == nullptr || new_inflections(q) != new_inflections(other->measures.quality)) {
        parts.push_back(count_text(new_inflections(q), "new inflection"));
    }
    if (other == nullptr || q.flipped != other->measures.quality.flipped) {
        parts.push_back(count_text(q.flipped, "flipped triangle"));
    }
    return fmt::format("{}", fmt::join(parts, " and "));
}

std::string sign_text(const MethodRun& run)
{
    return short_number(100 * run.measures.quality.gauss_sign_change) + " %";
}

/// Of every method that gave a result, ranked or not; less than any bulge where there is none.
double bulge_of_result(const MethodRun& run)
{
    return run.move && run.measures.has_compressed ? std::abs(run.measures.quality.bulge_max_mm) : -1;
}

std::string bulge_text(const MethodRun& run) { return size_text(std::abs(run.measures.quality.bulge_max_mm)); }

} // namespace

std::vector<int> rank_runs(const std::vector<MethodRun>& runs)
{
    const double least = least_bulge(runs);
    const auto key = [&](int k) {
        const Measures& m = runs[k].measures;
        const QualityReport& q = m.quality;
        const double bulge = m.has_compressed ? std::abs(q.bulge_max_mm) : 0;
        const bool near = !m.has_compressed || bulge <= least + equal_bulge * q.slide_max_mm;
        return std::tuple(!keeps_limits(runs[k]), q.flipped, near ? 0 : bulge, new_inflections(q),
                          m.has_compressed ? -q.squash : 0, q.gauss_sign_change);
    };
    std::vector<int> ranking;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        if (runs[k].sound()) {
            ranking.push_back(static_cast<int>(k));
        }
    }
    std::ranges::stable_sort(ranking, {}, key);
    return ranking;
}

std::string comparison_headline(const std::vector<MethodRun>& runs, const std::vector<int>& ranking)
{
    if (ranking.empty()) {
        return runs.size() == 1 ? fmt::format("{} gave no result that can be ranked.", runs.front().method)
                                : "None of the methods gave a result that can be ranked.";
    }
    const MethodRun& best = runs[ranking.front()];
    const bool bulge = best.measures.has_compressed;
    std::string text = fmt::format("{} comes first", best.method);
    if (bulge) {
        text += fmt::format(": its bulge is {}, {} % of the {} slide", bulge_text(best),
                            short_number(100 * best.measures.quality.bulge_fraction),
                            size_text(best.measures.quality.slide_max_mm));
    }
    text += fmt::format(", with {}", blemishes(best, nullptr));
    if (!bulge) {
        text += fmt::format("; the curvature's sign changes on {} of the region", sign_text(best));
    }
    const auto keeping = std::ranges::count_if(ranking, [&](int k) { return keeps_limits(runs[k]); });
    text += keeping == 1 && !best.gates.empty() && ranking.size() > 1 ? "; it alone keeps all limits." : ".";
    if (ranking.size() == 1) {
        return text;
    }
    const MethodRun& next = runs[ranking[1]];
    const std::string first = bulge ? bulge_text(next) : sign_text(next), worse = blemishes(next, &best);
    const bool equal = worse.empty() && first == (bulge ? bulge_text(best) : sign_text(best));
    text += equal ? fmt::format(" {} does as well", next.method)
                  : fmt::format(" {} follows with {}{}{}", next.method, first, worse.empty() ? "" : " and ", worse);
    const auto worst = std::ranges::max_element(runs, {}, bulge_of_result);
    if (bulge && &*worst != &best && &*worst != &next) {
        text += fmt::format("; {} bulges most, {}{}", worst->method, bulge_text(*worst),
                            worst->sound() ? "" : ", and is not ranked");
    }
    return text + ".";
}

std::string comparison_table(const Comparison& c)
{
    std::vector<std::vector<std::string>> rows = {{"method", "bulge [mm]", "inflections", "sign change [%]", "squash",
                                                   "flips", "error [mm]", "seconds", "verdict"}};
    const auto row = [&](const MethodRun& run, const std::string& verdict) {
        if (!run.move) {
            rows.push_back({run.method, "-", "-", "-", "-", "-", "-", fmt::format("{:.2f}", run.seconds), verdict});
            return;
        }
        const QualityReport& q = run.measures.quality;
        rows.push_back(
            {run.method, run.measures.has_compressed ? fmt::format("{:.4g}", q.bulge_max_mm) : "-",
             fmt::format("{}, {}", q.compressed_sections.inflections_after, q.tension_sections.inflections_after),
             fmt::format("{:.2f}", 100 * q.gauss_sign_change), fmt::format("{:.3f}", q.squash),
             std::to_string(q.flipped), fmt::format("{:.2g}", run.move->error_estimate_mm()),
             fmt::format("{:.2f}", run.seconds), verdict});
    };
    for (std::size_t place = 0; place < c.ranking.size(); ++place) {
        row(c.runs[c.ranking[place]], fmt::format("{}", place + 1));
    }
    std::string reasons;
    for (const MethodRun& run : c.runs) {
        if (!run.sound()) {
            row(run, !run.move ? "failed" : (run.move->converged() ? "ambiguous" : "not converged"));
            reasons += fmt::format("{}: {}\n", run.method, run.failure->message);
        }
    }
    return text_table(rows) + reasons + comparison_headline(c.runs, c.ranking) + "\n";
}

} // namespace tapeline
