// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/target_file.h"
#include "tests/support/files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>

namespace tapeline {
namespace {

using testing::TemporaryFolder;

/// A STEP file with wireframe curves: `curves` are entities from #100 on, `members` names the curves among them.
std::string step_file(const std::string& unit, const std::string& curves, const std::string& members)
{
    return fmt::format(R"(ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('curves','2024-01-01T00:00:00',(''),(''),'','','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN {{ 1 0 10303 214 1 1 1 1 }}'));
ENDSEC;
DATA;
#1 = APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#2);
#2 = APPLICATION_CONTEXT('core data for automotive mechanical design processes');
#3 = SHAPE_DEFINITION_REPRESENTATION(#4,#10);
#4 = PRODUCT_DEFINITION_SHAPE('','',#5);
#5 = PRODUCT_DEFINITION('design','',#6,#9);
#6 = PRODUCT_DEFINITION_FORMATION('','',#7);
#7 = PRODUCT('line','line','',(#8));
#8 = PRODUCT_CONTEXT('',#2,'mechanical');
#9 = PRODUCT_DEFINITION_CONTEXT('part definition',#2,'design');
#10 = GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION('',(#11,#15),#28);
#11 = AXIS2_PLACEMENT_3D('',#12,#13,#14);
#12 = CARTESIAN_POINT('',(0.,0.,0.));
#13 = DIRECTION('',(0.,0.,1.));
#14 = DIRECTION('',(1.,0.,0.));
#15 = GEOMETRIC_CURVE_SET('',({}));
#28 = ( GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#32))
GLOBAL_UNIT_ASSIGNED_CONTEXT((#29,#30,#31)) REPRESENTATION_CONTEXT('','') );
#29 = ( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT({},.METRE.) );
#30 = ( NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.) );
#31 = ( NAMED_UNIT(*) SI_UNIT($,.STERADIAN.) SOLID_ANGLE_UNIT() );
#32 = UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-07),#29,'','');
{}ENDSEC;
END-ISO-10303-21;
)",
                       members, unit, curves);
}

/// A straight piece as entities #n .. #n+2.
std::string piece(int n, const Vec3& a, const Vec3& b)
{
    return fmt::format("#{} = B_SPLINE_CURVE_WITH_KNOTS('',1,(#{},#{}),.UNSPECIFIED.,.F.,.F.,(2,2),(0.,1.),"
                       ".UNSPECIFIED.);\n#{} = CARTESIAN_POINT('',({:.6f},{:.6f},{:.6f}));\n"
                       "#{} = CARTESIAN_POINT('',({:.6f},{:.6f},{:.6f}));\n",
                       n, n + 1, n + 2, n + 1, a.x(), a.y(), a.z(), n + 2, b.x(), b.y(), b.z());
}

TEST(TargetCurves, AreJoinedEndToEndWhateverTheirOrderAndSense)
{
    const TemporaryFolder folder;
    const Vec3 a(0, 0, 0), b(10, 0, 0), c(20, 5, 0), d(30, 5, 4);
    folder.write("line.step",
                 step_file(".MILLI.", piece(100, b, c) + piece(110, a, b) + piece(120, d, c), "#100,#110,#120"));
    const auto line = read_target(folder / "line.step");
    ASSERT_TRUE(line) << line.error().message;
    EXPECT_FALSE(line->closed());
    EXPECT_NEAR(line->length(), 10 + (c - b).norm() + (d - c).norm(), 1e-9);
    EXPECT_NEAR((line->point(line->first_parameter()) - a).norm(), 0, 1e-9);
    EXPECT_NEAR((line->point(line->last_parameter()) - d).norm(), 0, 1e-9);
    for (const Vec3& p : {a, b, c, d}) {
        EXPECT_NEAR(line->foot(p).distance, 0, 1e-9);
    }
}

TEST(TargetCurves, ComeInMillimetres)
{
    const TemporaryFolder folder;
    for (const auto& [unit, factor] : {std::pair(".MILLI.", 1.0), std::pair(".CENTI.", 10.0), std::pair("$", 1000.0)}) {
        folder.write("line.stp", step_file(unit, piece(100, Vec3(0, 0, 0), Vec3(3, 4, 0)), "#100"));
        const auto line = read_target(folder / "line.stp");
        ASSERT_TRUE(line) << line.error().message;
        EXPECT_NEAR(line->length(), 5 * factor, 1e-9 * factor);
    }
}

TEST(TargetCurves, OfAnArcAndALineKeepTheirExactShape)
{
    const TemporaryFolder folder;
    // A quarter circle of radius 50 and its tangent; the arc is rational, the line is not.
    const std::string arc = "#200 = TRIMMED_CURVE('',#201,(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(1.5707963267948966)),"
                            ".T.,.PARAMETER.);\n#201 = CIRCLE('',#11,50.);\n";
    folder.write("line.step", step_file(".MILLI.", arc + piece(100, Vec3(0, 50, 0), Vec3(-70, 50, 0)), "#200,#100"));
    const auto line = read_target(folder / "line.step");
    ASSERT_TRUE(line) << line.error().message;
    EXPECT_NEAR(line->length(), 25 * std::numbers::pi + 70, 1e-6);
    for (int i = 0; i <= 100; ++i) {
        const Vec3 p = line->point(line->parameter_at(line->length() * i / 100));
        EXPECT_NEAR(p.x() > 0 ? p.norm() - 50 : p.y() - 50, 0, 1e-6);
    }
}

TEST(TargetCurves, ThatAreSeveralLinesAreRefusedWithTheirNumber)
{
    const TemporaryFolder folder;
    const std::string curves = piece(100, Vec3(0, 0, 0), Vec3(1, 0, 0)) + piece(110, Vec3(2, 0, 0), Vec3(3, 0, 0)) +
                               piece(120, Vec3(3, 0, 0), Vec3(3, 1, 0)) + piece(130, Vec3(0, 9, 0), Vec3(1, 9, 0));
    folder.write("lines.step", step_file(".MILLI.", curves, "#100,#110,#120,#130"));
    const auto line = read_target(folder / "lines.step");
    ASSERT_FALSE(line);
    EXPECT_NE(line.error().message.find("3 separate lines"), std::string::npos) << line.error().message;
    EXPECT_NE(line.error().message.find("lines.step"), std::string::npos);
}

TEST(TargetCurves, ThatBranchAreRefusedWithThePlace)
{
    const TemporaryFolder folder;
    const std::string curves = piece(100, Vec3(0, 0, 0), Vec3(7, 3, 0)) + piece(110, Vec3(7, 3, 0), Vec3(9, 0, 0)) +
                               piece(120, Vec3(7, 3, 0), Vec3(9, 9, 0));
    folder.write("lines.step", step_file(".MILLI.", curves, "#100,#110,#120"));
    const auto line = read_target(folder / "lines.step");
    ASSERT_FALSE(line);
    EXPECT_NE(line.error().message.find("(7, 3, 0)"), std::string::npos) << line.error().message;
}

TEST(TargetCurves, OfAWholeModelAreNoTarget)
{
    const std::filesystem::path hood = std::filesystem::path(TAPELINE_SOURCE_DIR) / "resources/models/hood.step";
    if (!std::filesystem::exists(hood)) {
        GTEST_SKIP() << "no " << hood;
    }
    const auto line = read_target(hood);
    ASSERT_FALSE(line);
    EXPECT_NE(line.error().message.find("hood.step"), std::string::npos) << line.error().message;
}

} // namespace
} // namespace tapeline
