// SPDX-License-Identifier: GPL-3.0-or-later
// What a bulge is measured from: the faces of a CAD model, or the triangles of a mesh.
#include "tests/plugin/run_command.h"

#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tapeline::testing {
namespace {

using nlohmann::json;

const std::string hood = TAPELINE_SOURCE_DIR "/resources/models/hood.step";

class MovedHood : public ::testing::Test {
protected:
    void SetUp() override
    {
        // On the import's own triangles, so that the moved mesh can be matched with the CAD file.
        const CommandRun run = run_tapeline({"move", hood, "--line", "0@10%..85%", "--slide", "0,30,0", "-o",
                                             file("m.obj"), "--tolerance", "0.02", "--roi-distance", "400", "--remesh",
                                             "off", "--rest", file("r.obj"), "--stats", file("s.json"), "--quiet"});
        ASSERT_EQ(run.exit_code, 0) << run.err;
        moved_ = json::parse(read_text(file("s.json")))["quality"]["bulge"];
    }

    std::string file(const std::string& name) const { return (folder_ / name).string(); }

    json check(const std::string& against, std::vector<std::string> more) const
    {
        more.insert(more.begin(), {"check", file("m.obj"), "--against", against, "--json", "-", "--quiet"});
        const CommandRun run = run_tapeline(more);
        EXPECT_EQ(run.exit_code, 0) << run.err;
        return json::parse(run.out)["measures"];
    }

    TemporaryFolder folder_;
    json moved_;
};

TEST_F(MovedHood, IsOnItsCadFacesAndACheckAgainstTheFileSaysSoToo)
{
    EXPECT_EQ(moved_["reference"], "exact");
    EXPECT_EQ(moved_["fallback_vertices"], 0);
    EXPECT_LT(std::abs(moved_["max_mm"].get<double>()), 1e-6);

    const json from_cad = check(hood, {"--stats", file("s.json")})["bulge"];
    EXPECT_EQ(from_cad["reference"], "exact");
    EXPECT_LT(std::abs(from_cad["max_mm"].get<double>()), 1e-6);
    EXPECT_GT(from_cad["rms_mm"].get<double>(), 0);
}

TEST_F(MovedHood, ShowsItsTrianglesChordsWhereOnlyMeshesAreKnown)
{
    const json from_mesh = check(file("r.obj"), {"--stats", file("s.json")})["bulge"];
    EXPECT_EQ(from_mesh["reference"], "triangles");
    EXPECT_EQ(from_mesh["fallback_vertices"], 0);
    EXPECT_GT(from_mesh["max_mm"].get<double>(), 0.05); // the import's triangles are coarse
}

TEST_F(MovedHood, HasDistancesFromTheFacesOrTheTrianglesOfAnotherModel)
{
    write_panel(folder_ / "other.obj");
    for (const auto& [against, reference] : {std::pair(hood, "exact"), std::pair(file("m.obj"), "triangles")}) {
        const CommandRun run =
            run_tapeline({"check", file("other.obj"), "--against", against, "--json", "-", "--quiet"});
        ASSERT_EQ(run.exit_code, 0) << run.err;
        const json distance = json::parse(run.out)["measures"]["surface_distance"];
        EXPECT_EQ(distance["reference"], reference);
        EXPECT_GT(distance["max_mm"].get<double>(), 1);
    }
}

} // namespace
} // namespace tapeline::testing
