// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/html_report.h"

#include "plugin/runner/strips.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tapeline {

namespace {

std::string move_headline(const JobOutcome& o)
{
    const QualityReport& q = o.measures.quality;
    std::string text = fmt::format("The line moves by up to {:.4g} mm", q.slide_max_mm);
    if (o.measures.has_compressed) {
        text += fmt::format(" and the side that gives way leaves its old surface by at most {:.2g} mm "
                            "({:.2g} % of the move)",
                            std::abs(q.bulge_max_mm), 100 * q.bulge_fraction);
    }
    std::vector<std::string> missed;
    for (const GateResult& gate : o.gates) {
        if (!gate.passed) {
            missed.push_back(gate.name);
        }
    }
    if (o.gates.empty()) {
        return text + ".";
    }
    return text + (missed.empty() ? fmt::format(". All {} limits are kept.", o.gates.size())
                                  : fmt::format(". {} of {} limits are missed: {}.", missed.size(), o.gates.size(),
                                                fmt::join(missed, ", ")));
}

PageEntry entry_of(const Job& job, const JobOutcome& outcome)
{
    PageEntry entry;
    entry.name = job.move.method;
    entry.title = method_title(entry.name);
    entry.move = &outcome.move;
    entry.measures = &outcome.measures;
    entry.inner_lines = outcome.inner_lines;
    const bool converged = outcome.move.converged(), ambiguous = outcome.move.ambiguous();
    entry.sound = converged && !ambiguous;
    entry.verdict = !converged ? "not converged" : (ambiguous ? "ambiguous" : "converged");
    if (!entry.sound) {
        entry.reason = (converged ? ambiguity(outcome.move) : not_converged(outcome.move)).message;
    }
    for (const auto& [stage, seconds] : outcome.move.seconds) {
        entry.seconds += seconds;
    }
    return entry;
}

} // namespace

std::vector<std::pair<std::string, std::string>> job_facts(const Job& job, const Preparation& p, const MoveResult* move)
{
    std::vector<std::pair<std::string, std::string>> facts = {
        {"Model", fmt::format("{}, {}", model_name(job), p.import.format)}};
    const FeatureLine& line = move == nullptr ? p.line : move->correspondence.line;
    facts.emplace_back("Line", fmt::format("{:.4g} mm long, {:.3g}° sharp", line.length_mm, line.crease_angle_mean));
    facts.emplace_back("Region",
                       fmt::format("{} vertices, {} triangles", p.region.vertices.size(), p.region.faces.size()));
    if (move != nullptr) {
        const bool on = move->placement.verdict == Placement::on_surface;
        facts.emplace_back("Move", fmt::format("up to {:.4g} mm, {}", move->placement.u_max_mm,
                                               on ? "along the surface" : "off the surface"));
        if (on) {
            facts.emplace_back("Gives way", move->placement.compressed == LineSide::left ? "left side" : "right side");
        }
        if (const std::string strip = strip_text(*move); !strip.empty()) {
            facts.emplace_back("Strip", strip);
        }
    }
    return facts;
}

std::string model_name(const Job& job) { return job.input.empty() ? "model in memory" : job.input.filename().string(); }

std::string method_title(const std::string& method)
{
    const auto known = method_named(method);
    return known ? std::string(method_info(*known).title) : std::string();
}

std::vector<std::string> reading_notes()
{
    return {
        "Bulge: distance of the side that gives way to its old surface (exact CAD faces, else triangles); 0 is best.",
        "Inflections and turning: worst of nine sections across the moved line, each side on its own.",
        "Gauss sign: share of area, there and in all, whose Gaussian curvature changed between dome and saddle.",
        "Crown: change of the other side's mean curvature; -1 is pulled straight, 0 is kept, 1 is twice as round.",
        "Crease: RMS difference of the angle across the line after and before.",
        "Rim crease: change of the angle across the region's border. End kink: across the line's prolongation.",
        "Squash: smallest remaining width of a triangle, measured across the line, as a share of its width before.",
        "Flips: triangles turned over. Unique to: how far apart the method ends from two starts."};
}

std::string html_report(const Job& job, const JobOutcome& outcome, const std::vector<Picture>& pictures,
                        const Stage& stage)
{
    Page page;
    page.title = fmt::format("{}: {}", model_name(job), job.move.method);
    page.headline = move_headline(outcome);
    page.description = job.description;
    page.facts = job_facts(job, outcome.preparation, &outcome.move);
    page.facts.emplace_back("Method", job.move.method);
    page.entries = {entry_of(job, outcome)};
    for (const Picture& picture : pictures) {
        if (picture.name.starts_with("before_")) {
            page.before.push_back(picture);
        } else if (picture.name.starts_with("after_")) {
            page.entries.front().pictures.push_back(picture);
        } else {
            page.entries.front().sections = picture;
        }
    }
    page.target = &outcome.preparation.target->line;
    page.stage = &stage;
    page.warnings = outcome.warnings;
    page.notes = reading_notes();
    page.footer = fmt::format("tapeline {}, input SHA-256 {}", version(), outcome.input_sha256);
    return page_html(page);
}

} // namespace tapeline
