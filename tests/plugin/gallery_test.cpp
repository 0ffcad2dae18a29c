// SPDX-License-Identifier: GPL-3.0-or-later
// The gallery's jobs under every method, on coarser meshes than the gallery's own: where the line moves on the surface,
// asan-fl is the best or as good as the best, and never behind the published method. Its thin-plate sister stands aside.
#include "kernel/method.h"
#include "plugin/runner/comparison.h"
#include "plugin/runner/job_file.h"
#include "tests/support/files.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace tapeline::testing {
namespace {

namespace fs = std::filesystem;

struct GalleryJob {
    const char* name;
    double max_edge; ///< [mm]
};
void PrintTo(const GalleryJob& job, std::ostream* out) { *out << job.name; }

class Gallery : public ::testing::TestWithParam<GalleryJob> {
protected:
    void SetUp() override
    {
        auto job =
            read_job(fs::path(TAPELINE_SOURCE_DIR) / "resources/jobs" / (std::string(GetParam().name) + ".json"));
        ASSERT_TRUE(job) << job.error().message;
        job->remesh.max_edge = GetParam().max_edge;
        job->move.check_unique = true;
        auto compared = compare_methods(*job);
        ASSERT_TRUE(compared) << compared.error().message;
        comparison_ = std::move(*compared);
        ours_ = run_of("asan-fl");
        ASSERT_NE(ours_, nullptr);
        ASSERT_TRUE(ours_->sound()) << ours_->failure->message;
    }

    const MethodRun* run_of(std::string_view method) const
    {
        const auto found = std::ranges::find(comparison_.runs, method, &MethodRun::method);
        return found == comparison_.runs.end() ? nullptr : &*found;
    }
    double slack() const { return 0.01 * ours_->move->placement.u_max_mm; }
    static double bulge(const MethodRun& run) { return std::abs(run.measures.quality.bulge_max_mm); }
    static int inflections(const MethodRun& run)
    {
        const SectionMeasure& m = run.measures.quality.compressed_sections;
        return std::max(0, m.inflections_after - m.inflections_before);
    }

    void compare_with_published() const
    {
        const MethodRun* published = run_of("asan-fl-paper");
        ASSERT_NE(published, nullptr);
        if (!published->move) {
            return; // it could not do the job at all
        }
        EXPECT_LE(bulge(*ours_), bulge(*published) + slack());
        EXPECT_LE(ours_->measures.quality.flipped, published->measures.quality.flipped);
        // A surface that buckles away keeps its triangles' heights; only one that stays down can be compared.
        const bool buckles = bulge(*published) > ours_->move->placement.u_max_mm;
        EXPECT_TRUE(buckles || ours_->measures.quality.squash >= published->measures.quality.squash - 0.01);
    }

    void compare_with_plate() const
    {
        const MethodRun* plate = run_of("plate-fl");
        ASSERT_NE(plate, nullptr);
        ASSERT_TRUE(plate->sound()) << plate->failure->message;
        const QualityReport &quality = plate->measures.quality, &asan = ours_->measures.quality;
        EXPECT_LE(bulge(*plate), bulge(*ours_) + slack());
        EXPECT_LE(inflections(*plate), inflections(*ours_));
        EXPECT_EQ(quality.flipped, 0);
        EXPECT_GE(quality.squash, asan.squash - 0.03);
        EXPECT_LE(quality.rim_crease_mean_change, asan.rim_crease_mean_change + 0.1);
    }

    Comparison comparison_;
    const MethodRun* ours_ = nullptr;
};

TEST_P(Gallery, IsWonByAsanFlAndItsThinPlate)
{
    ASSERT_EQ(comparison_.runs.size(), method_table().size());
    const QualityReport& quality = ours_->measures.quality;
    EXPECT_EQ(quality.flipped, 0);
    EXPECT_GE(quality.squash, 0.5);
    EXPECT_TRUE(ours_->move->uniqueness.checked);
    EXPECT_LT(ours_->move->uniqueness.distance_mm, 0.1);
    for (const MethodRun& run : comparison_.runs) {
        if (run.sound() && run.method != "plate-fl") {
            EXPECT_LE(bulge(*ours_), bulge(run) + slack()) << run.method;
            // A method that bulges less may not be flatter at the price of waves.
            EXPECT_TRUE(inflections(*ours_) <= inflections(run) || bulge(*ours_) + slack() < bulge(run)) << run.method;
        }
    }
    compare_with_published();
    compare_with_plate();
}

INSTANTIATE_TEST_SUITE_P(Job, Gallery,
                         ::testing::Values(GalleryJob{"hood", 25}, GalleryJob{"hood_above", 25},
                                           GalleryJob{"bracket", 2.5}, GalleryJob{"wheel_arch", 12},
                                           GalleryJob{"pawn", 2}, GalleryJob{"hood_zigzag", 25},
                                           GalleryJob{"hood_open_end", 25}),
                         [](const auto& job) { return job.param.name; });

} // namespace
} // namespace tapeline::testing
