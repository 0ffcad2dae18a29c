// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/pictures.h"

#include "io/picture.h"
#include "plugin/runner/measures.h"
#include "plugin/runner/target_choice.h"

#include <array>
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

} // namespace

Result<std::vector<Picture>> draw_move(const MoveResult& move, const TargetCurve& target)
{
    const Mesh& before = move.rest.mesh;
    const Mesh after{move.V, before.F};
    const QualityInput input = quality_input(move, target);
    const QualityMaps maps = quality_maps(input);
    const FeatureLine& line = move.correspondence.line;
    const PictureLine old_line = picture_line(line_points(before, line), line.closed, old_colour);
    const PictureLine new_line = picture_line(line_points(after, line), line.closed, new_colour);

    Album album;
    const Camera camera = fit_camera(before, move.region.faces);
    // The same stripes before and after, or the two could not be compared.
    const double zebra_period = fit_zebra(before, camera, move.region.faces);
    const auto add = [&](const std::string& kind, const std::string& title, Shading shading, bool lines,
                         const std::vector<double>& values_before, const std::vector<double>& values_after) {
        PictureOptions options;
        options.shading = shading;
        options.camera = camera;
        options.zebra_period = zebra_period;
        options.sharp_lines = {line.vertices};
        options.values = values_before;
        options.lines = lines ? std::vector{old_line, new_line} : std::vector<PictureLine>{};
        album.add(fmt::format("before_{}.png", kind), title + ", before",
                  [&](const fs::path& path) { return draw_mesh(path, before, options); });
        options.values = values_after;
        album.add(fmt::format("after_{}.png", kind), title + ", after",
                  [&](const fs::path& path) { return draw_mesh(path, after, options); });
    };
    add("shaded", "Shaded", Shading::shaded, true, {}, {});
    add("zebra", "Zebra stripes", Shading::zebra, false, {}, {});
    add("curvature", "Sign of the Gaussian curvature", Shading::curvature_sign, false, maps.gauss_before,
        maps.gauss_after);
    album.add("sections.png", "Sections across the line, with curvature combs",
              [&](const fs::path& path) { return draw_sections(path, cross_sections(input)); });
    return album.finish();
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
