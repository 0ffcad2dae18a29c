// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/pictures.h"

#include "io/picture.h"
#include "plugin/runner/measures.h"
#include "plugin/runner/target_choice.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <functional>
#include <iterator>

namespace tapeline {

namespace {

namespace fs = std::filesystem;

/// A folder for files that are read back at once.
class ScratchFolder {
public:
    ScratchFolder()
    {
        std::error_code error;
        std::string name = (fs::temp_directory_path(error) / "tapeline-XXXXXX").string();
        if (mkdtemp(name.data()) != nullptr) {
            path_ = name;
        }
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    ~ScratchFolder()
    {
        std::error_code error;
        if (!path_.empty()) {
            fs::remove_all(path_, error);
        }
    }
    const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

/// Draws pictures into a scratch folder and keeps their bytes.
class Album {
public:
    using Draw = std::function<Result<void>(const fs::path&)>;

    void add(const std::string& name, const std::string& title, const Draw& draw)
    {
        if (!failure_) {
            failure_ = picture(name, title, draw);
        }
    }
    Result<std::vector<Picture>> finish()
    {
        if (failure_) {
            return tl::unexpected(*failure_);
        }
        return std::move(pictures_);
    }

private:
    std::optional<Error> failure_;
    ScratchFolder folder_;
    std::vector<Picture> pictures_;

    std::optional<Error> picture(const std::string& name, const std::string& title, const Draw& draw)
    {
        if (folder_.path().empty()) {
            return Error{ErrorKind::unreadable, "cannot make a temporary folder for pictures; check TMPDIR"};
        }
        const fs::path path = folder_.path() / name;
        if (const auto drawn = draw(path); !drawn) {
            return drawn.error();
        }
        std::ifstream file(path, std::ios::binary);
        pictures_.push_back({name, title, std::string(std::istreambuf_iterator<char>(file), {})});
        return std::nullopt;
    }
};

PictureLine picture_line(std::vector<Vec3> points, bool closed, const std::array<double, 3>& colour)
{
    if (closed && !points.empty()) {
        points.push_back(points.front());
    }
    return {std::move(points), colour, {}};
}

constexpr std::array<double, 3> old_colour{0.1, 0.35, 0.75};
constexpr std::array<double, 3> new_colour{0.85, 0.1, 0.1};
constexpr std::array<double, 3> dark_colour{0.13, 0.15, 0.18};
constexpr double section_width = 1.6;

/// Sections to choose the close-up's from: many, so that the largest move is hardly missed, and odd, so that the line's
/// middle is among them.
std::vector<Section> closeup_sections(QualityInput input)
{
    input.stations = 33;
    return cross_sections(input);
}

double moved_by(const QualityInput& input, int v) { return (input.moved.row(v) - input.rest.V.row(v)).norm(); }

/// The section where the line has moved farthest; of places that moved alike the one nearest to the line's middle.
const Section* farthest_moved(const std::vector<Section>& sections, const QualityInput& input, double slide)
{
    const auto middle = static_cast<int>(sections.size()) / 2;
    const Section* found = nullptr;
    std::pair<double, int> best;
    for (int k = 0; k < static_cast<int>(sections.size()); ++k) {
        const Section& s = sections[k];
        if (s.compressed_after.empty() || s.tension_after.empty()) {
            continue;
        }
        const int nearest = *std::ranges::min_element(
            input.line, {}, [&](int v) { return (Vec3(input.moved.row(v)) - s.origin).squaredNorm(); });
        const double share = slide > 0 ? moved_by(input, nearest) / slide : 0;
        const std::pair score(std::round(100 * share), -std::abs(k - middle));
        if (found == nullptr || score > best) {
            found = &s;
            best = score;
        }
    }
    return found;
}

/// Aims at the section where the line has moved farthest, the compressed side on the left, a little from above.
void aim_closeup(Stage& stage, const QualityInput& input)
{
    double slide = 0;
    for (const int v : input.line) {
        slide = std::max(slide, moved_by(input, v));
    }
    const std::vector<Section> sections = closeup_sections(input);
    const Section* chosen = farthest_moved(sections, input, slide);
    if (chosen == nullptr) {
        return;
    }
    const Section& s = *chosen;
    const Vec3 across = s.tension_after.back() - s.compressed_after.back();
    const Vec3 ahead = s.normal.cross(s.outward).dot(across) > 0 ? s.normal : Vec3(-s.normal);
    constexpr double descent = 0.24; // of the view's direction towards the surface, about 14 degrees
    const double width = std::clamp(7 * slide, 0.3 * across.norm(), 1.1 * across.norm());
    stage.cut = {s.origin, ahead};
    // The section lies below the middle, for what is behind it rises in the picture.
    stage.closeup.target = s.origin + 0.1 * width * s.outward;
    stage.closeup.direction = (ahead - descent * s.outward).normalized();
    stage.closeup.up = s.outward;
    stage.closeup.height_mm = 0.75 * width;
    stage.has_closeup = true;
}

/// The part of the state behind the cutting plane, with the section in it drawn.
Result<void> draw_closeup(const fs::path& path, const MoveResult& move, const TargetCurve& target, bool after,
                          const Stage& stage, PictureOptions options)
{
    const Mesh whole{after ? move.V : move.rest.mesh.V, move.rest.mesh.F};
    const auto clipped = clip_mesh(whole, faces_in(move.rest.mesh, shown_box(move.rest.mesh, move.region)), stage.cut);
    if (!clipped) {
        return tl::unexpected(clipped.error());
    }
    std::vector<int> kept;
    for (const int v : whole_line(move.correspondence.line)) {
        if (clipped->vertex[v] >= 0) {
            kept.push_back(clipped->vertex[v]);
        }
    }
    options.sharp_lines = {kept};
    options.camera = stage.closeup;
    options.values.clear();
    options.shading = Shading::shaded;
    options.lines.clear();
    const std::vector<Section> sections = closeup_sections(quality_input(move, target));
    // Every method's line lies on the target, so the same place is found in all of them.
    const auto s = std::ranges::min_element(
        sections, {}, [&](const Section& section) { return (section.origin - stage.cut.point).squaredNorm(); });
    if (s != sections.end()) {
        const bool one_plane = s->rest_normal == s->normal;
        for (const auto* before : {&s->compressed_before, &s->tension_before}) {
            if (one_plane) {
                options.lines.push_back({*before, after ? dark_colour : old_colour, {}, after, section_width});
            }
        }
        for (const auto* moved : {&s->compressed_after, &s->tension_after}) {
            if (after) {
                options.lines.push_back({*moved, new_colour, {}, false, section_width});
            }
        }
    }
    return draw_mesh(path, clipped->mesh, options);
}

} // namespace

std::vector<int> whole_line(const FeatureLine& line)
{
    std::vector<int> chain(line.before.rbegin(), line.before.rend());
    chain.insert(chain.end(), line.vertices.begin(), line.vertices.end());
    chain.insert(chain.end(), line.after.begin(), line.after.end());
    if (line.closed) {
        chain.push_back(chain.front());
    }
    return chain;
}

Eigen::AlignedBox3d shown_box(const Mesh& mesh, const Region& region)
{
    constexpr double margin = 0.08;
    Eigen::AlignedBox3d box;
    for (const int v : region.vertices) {
        box.extend(Vec3(mesh.V.row(v)));
    }
    const Vec3 grow = Vec3::Constant(margin * box.diagonal().norm());
    return {box.min() - grow, box.max() + grow};
}

std::vector<int> faces_in(const Mesh& mesh, const Eigen::AlignedBox3d& box)
{
    std::vector<int> faces;
    for (int t = 0; t < mesh.F.rows(); ++t) {
        Eigen::AlignedBox3d triangle;
        for (int k = 0; k < 3; ++k) {
            triangle.extend(Vec3(mesh.V.row(mesh.F(t, k))));
        }
        if (box.intersects(triangle)) {
            faces.push_back(t);
        }
    }
    return faces;
}

Stage make_stage(const Mesh& model, const Region& region, const MoveResult& move, const TargetCurve& target)
{
    Stage stage;
    stage.camera = fit_camera(model, region.faces);
    // The same stripes before and after, or the two could not be compared.
    stage.zebra_period = fit_zebra(model, stage.camera, region.faces);
    aim_closeup(stage, quality_input(move, target));
    return stage;
}

Result<std::vector<Picture>> draw_state(const MoveResult& move, const TargetCurve& target, bool after,
                                        const Stage& stage, const PictureSize& size)
{
    const Mesh before{move.rest.mesh.V, move.rest.mesh.F}, moved{move.V, move.rest.mesh.F};
    const Mesh& mesh = after ? moved : before;
    const QualityMaps maps = quality_maps(quality_input(move, target));
    const FeatureLine& line = move.correspondence.line;
    const std::string word = after ? "after" : "before";
    Album album;
    PictureOptions options;
    options.width = size.width;
    options.height = size.height;
    options.camera = stage.camera;
    options.zebra_period = stage.zebra_period;
    options.sharp_lines = {whole_line(line)};
    options.legend = size.legend;
    const auto add = [&](const std::string& kind, const std::string& title, Shading shading) {
        options.shading = shading;
        album.add(fmt::format("{}_{}.png", word, kind), fmt::format("{}, {}", title, word),
                  [&](const fs::path& path) { return draw_mesh(path, mesh, options); });
    };
    options.lines = {picture_line(line_points(before, line), line.closed, old_colour)};
    if (after || size.both_lines) {
        options.lines.push_back(picture_line(line_points(moved, line), line.closed, new_colour));
    }
    add("shaded", "Shaded", Shading::shaded);
    options.lines.clear();
    add("zebra", "Zebra stripes", Shading::zebra);
    options.values = after ? maps.gauss_after : maps.gauss_before;
    add("curvature", "Sign of the Gaussian curvature", Shading::curvature_sign);
    if (stage.has_closeup) {
        album.add(fmt::format("{}_closeup.png", word),
                  fmt::format("Cut across the line where it moved farthest, {}", word),
                  [&](const fs::path& path) { return draw_closeup(path, move, target, after, stage, options); });
    }
    return album.finish();
}

Result<Picture> draw_section_panels(const MoveResult& move, const TargetCurve& target, int stations)
{
    QualityInput input = quality_input(move, target);
    input.stations = stations;
    Album album;
    album.add("sections.png", "Sections across the line, with curvature combs",
              [&](const fs::path& path) { return draw_sections(path, cross_sections(input)); });
    return album.finish().map([](std::vector<Picture> pictures) { return std::move(pictures.front()); });
}

Result<std::vector<Picture>> draw_move(const MoveResult& move, const TargetCurve& target, const Stage& stage)
{
    std::vector<Picture> pictures;
    for (const bool after : {false, true}) {
        auto drawn = draw_state(move, target, after, stage, {});
        if (!drawn) {
            return drawn;
        }
        std::ranges::move(*drawn, std::back_inserter(pictures));
    }
    return draw_section_panels(move, target, 9).map([&](Picture sections) {
        pictures.push_back(std::move(sections));
        return std::move(pictures);
    });
}

Result<void> draw_lines(const fs::path& png, const Mesh& mesh, const std::vector<FeatureLine>& lines)
{
    // Neighbouring numbers get colours that differ.
    static constexpr std::array<std::array<double, 3>, 6> colours = {
        {{0.85, 0.1, 0.1}, {0.1, 0.35, 0.75}, {0.1, 0.55, 0.2}, {0.75, 0.45, 0.0}, {0.5, 0.15, 0.6}, {0.0, 0.5, 0.55}}};
    PictureOptions options;
    for (const FeatureLine& line : lines) {
        const auto& colour = colours[static_cast<std::size_t>(std::max(line.id, 0)) % colours.size()];
        options.lines.push_back(picture_line(line_points(mesh, line), line.closed, colour));
        options.lines.back().label = std::to_string(line.id);
    }
    return draw_mesh(png, mesh, options);
}

} // namespace tapeline
