// SPDX-License-Identifier: GPL-3.0-or-later
// A line slid over a CAD model leaves the side it narrows on the model's own faces. OpenCASCADE reads the file once more
// and measures, with none of our code in between.
#include "plugin/runner/job_file.h"
#include "plugin/runner/measures.h"
#include "plugin/runner/preparation.h"
#include "plugin/runner/runner.h"

#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <deque>
#include <gtest/gtest.h>
#include <limits>
#include <set>

using namespace tapeline;

namespace {

const std::string resources = TAPELINE_SOURCE_DIR "/resources/";

/// The surfaces of a STEP file, as OpenCASCADE reads them.
class Surfaces {
public:
    explicit Surfaces(const std::string& path)
    {
        STEPControl_Reader reader;
        EXPECT_EQ(reader.ReadFile(path.c_str()), IFSelect_RetDone);
        reader.TransferRoots();
        for (TopExp_Explorer faces(reader.OneShape(), TopAbs_FACE); faces.More(); faces.Next()) {
            projections_.emplace_back();
            projections_.back().Init(gp_Pnt(0, 0, 0), BRep_Tool::Surface(TopoDS::Face(faces.Current())));
        }
    }

    double distance(const Vec3& p)
    {
        double least = std::numeric_limits<double>::infinity();
        for (GeomAPI_ProjectPointOnSurf& projection : projections_) {
            projection.Perform(gp_Pnt(p.x(), p.y(), p.z()));
            least = projection.NbPoints() > 0 ? std::min(least, projection.LowerDistance()) : least;
        }
        return least;
    }

private:
    std::deque<GeomAPI_ProjectPointOnSurf> projections_;
};

struct Slide {
    const char* job;
    const char* method;
    double times;    ///< the job's slide; negative goes to the other side
    double max_edge; ///< coarser than the job's own triangles: faster, and a harder test [mm]
};

std::ostream& operator<<(std::ostream& out, const Slide& slide)
{
    return out << slide.job << ", " << slide.method << ", " << slide.times;
}

Job job_of(const Slide& slide)
{
    Job job = *read_job(resources + "jobs/" + slide.job + ".json");
    job.outputs = {};
    job.move.method = slide.method;
    job.remesh.max_edge = slide.max_edge;
    for (double& mm : job.target.slide) {
        mm *= slide.times;
    }
    return job;
}

struct Moved {
    Preparation prepared;
    MoveResult move;
};

Moved move_by(const Job& job, const MoveOptions& options)
{
    Stopwatch watch;
    auto prepared = prepare(job, watch, {});
    if (!prepared) {
        throw std::runtime_error(prepared.error().message);
    }
    auto moved = move_feature_line(prepared->model, prepared->line, prepared->target->line, prepared->region, options);
    if (!moved) {
        throw std::runtime_error(moved.error().message);
    }
    return {std::move(*prepared), std::move(*moved)};
}

/// The compressed side's vertices that moved and are not on the line or its prolongation.
std::vector<int> free_vertices(const MoveResult& move)
{
    const auto& faces = move.placement.compressed == LineSide::left ? move.left_faces : move.right_faces;
    std::set<int> vertices;
    for (const int t : faces) {
        for (const int v : move.rest.mesh.F.row(t)) {
            if (move.V.row(v) != move.rest.mesh.V.row(v)) {
                vertices.insert(v);
            }
        }
    }
    for (const int v : move.extended_line) {
        vertices.erase(v);
    }
    return {vertices.begin(), vertices.end()};
}

class ExactSlide : public ::testing::TestWithParam<Slide> {};

} // namespace

TEST_P(ExactSlide, LeavesTheNarrowedSideOnTheCadFaces)
{
    const Job job = job_of(GetParam());
    const auto [prepared, move] = move_by(job, move_options(job));
    const std::vector<int> vertices = free_vertices(move);
    ASSERT_GT(vertices.size(), 300U);
    Surfaces surfaces(job.input.string());
    double farthest = 0, line = 0;
    for (const int v : vertices) {
        farthest = std::max(farthest, surfaces.distance(move.V.row(v)));
    }
    for (const int v : move.correspondence.line.vertices) {
        line = std::max(line, surfaces.distance(move.V.row(v)));
    }
    RecordProperty("farthest_mm", std::to_string(farthest));
    EXPECT_LT(farthest, 1e-6) << vertices.size() << " vertices";
    // The line is as near as its B-spline was fitted.
    EXPECT_LT(line, 1e-5 * prepared.target->line.length());
    EXPECT_NEAR(line, move.exact_surface.line_distance_mm, 1e-6);

    EXPECT_TRUE(move.exact_surface.applied);
    EXPECT_EQ(move.exact_surface.left, 0);
    EXPECT_EQ(move.exact_surface.vertices, static_cast<int>(vertices.size()));
    EXPECT_LT(move.exact_surface.distance_after_mm, 1e-6);

    // Nothing is lost for it.
    MoveOptions triangles = move_options(job);
    triangles.exact_surface = false;
    const auto other =
        move_feature_line(prepared.model, prepared.line, prepared.target->line, prepared.region, triangles);
    ASSERT_TRUE(other) << other.error().message;
    const auto exact = measure_move(move, prepared.target->line);
    const auto before = measure_move(*other, prepared.target->line);
    ASSERT_TRUE(exact && before);
    EXPECT_EQ(exact->quality.flipped, 0);
    EXPECT_LT(exact->quality.line_error_max_mm, 1e-9);
    EXPECT_GT(exact->quality.squash, 0.99 * before->quality.squash);
    EXPECT_LE(exact->quality.compressed_sections.inflections_after,
              before->quality.compressed_sections.inflections_after);
    for (const int v : move.region.fixed_rim) {
        EXPECT_TRUE(move.V.row(v) == move.rest.mesh.V.row(v)) << v;
    }
}

INSTANTIATE_TEST_SUITE_P(Models, ExactSlide,
                         ::testing::Values(Slide{"hood", "asan-fl", 1, 20}, Slide{"hood", "plate-fl", 1, 20},
                                           Slide{"panel", "asan-fl", 1, 14}, Slide{"panel", "plate-fl", 1, 14},
                                           Slide{"bracket", "asan-fl", 1, 2.5}, Slide{"bracket", "plate-fl", 1, 2.5},
                                           Slide{"bracket", "asan-fl", -1, 2.5}));

TEST(ExactSurface, IsLeftAloneWhenAskedToTheBit)
{
    Job job = job_of({"bracket", "asan-fl", -1, 2.5});
    job.move.exact_surface = "off";
    const auto [prepared, move] = move_by(job, move_options(job));
    EXPECT_FALSE(move.exact_surface.applied);
    Model mesh = prepared.model;
    mesh.surface.reset();
    for (const bool exact : {false, true}) {
        MoveOptions options = move_options(job);
        options.exact_surface = exact;
        const auto without = move_feature_line(mesh, prepared.line, prepared.target->line, prepared.region, options);
        ASSERT_TRUE(without) << without.error().message;
        EXPECT_TRUE(without->V == move.V);
    }
}

TEST(ExactSurface, LetsASideFollowATargetThatIsMeantToBeOffIt)
{
    Job job = job_of({"hood", "asan-fl", 1, 20});
    const auto [prepared, move] = move_by(job, move_options(job));
    // The same line, lifted by a fifth of the slide: still a move along the surface, but not on it.
    BSplineData lifted = prepared.target->line.data();
    for (Vec3& point : lifted.control_points) {
        point.z() += 12;
    }
    const auto target = TargetLine::from_data(lifted);
    ASSERT_TRUE(target);
    const auto off = move_feature_line(prepared.model, prepared.line, *target, prepared.region, move_options(job));
    ASSERT_TRUE(off) << off.error().message;
    ASSERT_EQ(off->placement.verdict, Placement::on_surface);
    EXPECT_FALSE(off->exact_surface.applied);
    EXPECT_GT(off->exact_surface.distance_after_mm, 5);
    EXPECT_TRUE(std::ranges::any_of(off->warnings, [](const std::string& warning) {
        return warning.find("off the exact surface") != std::string::npos;
    }));
}
