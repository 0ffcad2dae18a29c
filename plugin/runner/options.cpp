// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/options.h"

#include "kernel/method.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace tapeline {

namespace {

template <auto Member>
OptionSlot top(Job& job)
{
    return &(job.*Member);
}

template <auto Section, auto Member>
OptionSlot at(Job& job)
{
    return &((job.*Section).*Member);
}

constexpr unsigned reading = mesh_command | lines_command | target_command | move_command | check_command;
constexpr unsigned choosing = target_command | move_command;
constexpr unsigned finding = lines_command | choosing | check_command;
constexpr unsigned moving = move_command;
constexpr unsigned gating = move_command | check_command;

std::vector<std::string_view> method_names()
{
    std::vector<std::string_view> names;
    for (const MethodInfo& info : method_table()) {
        names.push_back(info.name);
    }
    return names;
}

// One record a paragraph: the formatter would give each field its own line.
// clang-format off

void add_model_options(std::vector<Option>& table)
{
    using I = ImportSettings;
    using R = RemeshSettings;
    constexpr auto i = &Job::import;
    constexpr auto r = &Job::remesh;
    table.insert(table.end(), {
        {.section = "", .name = "description", .slot = top<&Job::description>, .help = "A note for people; not used."},
        {.section = "", .name = "input", .slot = top<&Job::input>, .commands = reading,
         .help = "Model file: STEP, IGES, BREP, STL, OBJ, PLY or OFF, told apart by content.", .file = FileRole::input,
         .required = reading, .operand = true},
        {.section = "import", .name = "units", .slot = at<i, &I::units>, .commands = reading,
         .help = "Length unit of mesh files, for input and output; CAD files carry their own.",
         .choices = {"mm", "cm", "m", "in", "ft"}},
        {.section = "import", .name = "linear_deflection", .slot = at<i, &I::linear_deflection>, .commands = reading,
         .help = "CAD input: largest distance of a triangle edge to the exact surface.", .unit = "mm", .min = 0,
         .zero = "a ten-thousandth of the model's diagonal"},
        {.section = "import", .name = "angular_deflection", .slot = at<i, &I::angular_deflection>, .commands = reading,
         .help = "CAD input: largest angle between neighbouring triangles on a curved face.", .unit = "deg", .min = 0.1,
         .max = 45},
        {.section = "import", .name = "sew_tolerance", .slot = at<i, &I::sew_tolerance>, .commands = reading,
         .help = "CAD input: gaps up to this size between faces are closed.", .unit = "mm", .min = 0,
         .zero = "0.001 mm"},
        {.section = "remesh", .name = "remesh", .slot = at<r, &R::remesh>, .commands = choosing,
         .help = "Give the surroundings of the line even triangles first; auto does so for CAD input and when max_edge "
                 "is given.",
         .choices = {"auto", "on", "off"}},
        {.section = "remesh", .name = "max_edge", .slot = at<r, &R::max_edge>, .commands = mesh_command | choosing,
         .help = "Edge length that remeshing aims at.", .unit = "mm", .min = 0,
         .zero = "mesh: no remeshing; otherwise from the line's length"},
    });
}

void add_line_options(std::vector<Option>& table)
{
    using L = LineSettings;
    constexpr auto l = &Job::lines;
    table.insert(table.end(), {
        {.section = "lines", .name = "line", .slot = at<l, &L::line>, .commands = choosing | check_command,
         .help = "The feature line: ID, ID@FROM..TO (arc length in mm or %), or a file of vertex indices.",
         .required = choosing},
        {.section = "lines", .name = "crease_angle", .slot = at<l, &L::crease_angle>, .commands = finding,
         .help = "An edge at least this sharp starts a feature line.", .unit = "deg", .min = 0.1, .max = 180},
        {.section = "lines", .name = "crease_angle_low", .slot = at<l, &L::crease_angle_low>, .commands = finding,
         .help = "A started feature line goes on along edges at least this sharp.", .unit = "deg", .min = 0.05,
         .max = 180},
        {.section = "lines", .name = "max_turn", .slot = at<l, &L::max_turn>, .commands = finding,
         .help = "A feature line is cut where it turns by more than this.", .unit = "deg", .min = 1, .max = 180},
        {.section = "lines", .name = "min_length", .slot = at<l, &L::min_length>, .commands = finding,
         .help = "Shorter feature lines are dropped.", .unit = "mm", .min = 0},
    });
}

void add_target_options(std::vector<Option>& table)
{
    using T = TargetSettings;
    constexpr auto t = &Job::target;
    table.insert(table.end(), {
        {.section = "target", .name = "target", .slot = at<t, &T::target>, .commands = moving | check_command,
         .help = "Target line: JSON, STEP, IGES or BREP curve, or CSV polyline; without one the line is fitted.",
         .file = FileRole::input},
        {.section = "target", .name = "control_points", .slot = at<t, &T::control_points>, .commands = choosing,
         .help = "Number of control points of the fitted B-spline.", .min = 0, .max = 1000,
         .zero = "as few as the tolerance needs"},
        {.section = "target", .name = "tolerance", .slot = at<t, &T::tolerance>, .commands = choosing,
         .help = "Largest distance of the B-spline to what it is fitted to.", .unit = "mm", .min = 0,
         .zero = "from the line's sagitta and length"},
        {.section = "target", .name = "surface_points", .slot = at<t, &T::surface_points>, .commands = choosing,
         .help = "Number of control points of a line that is slid or laid on the surface; few are easier to edit.",
         .min = 0, .max = 1000, .zero = "as few as the tolerance needs"},
        {.section = "target", .name = "edit", .slot = at<t, &T::edit>, .commands = choosing,
         .help = "JSON file of control-point moves.", .file = FileRole::input},
        {.section = "target", .name = "slide", .slot = at<t, &T::slide>, .commands = choosing,
         .help = "Slide along the surface, to the left of the line if positive: one distance, or several spread "
                 "evenly over its length.",
         .unit = "mm"},
        {.section = "target", .name = "fair", .slot = at<t, &T::fair>, .commands = choosing,
         .help = "Smooth the curvature of the target line."},
        {.section = "target", .name = "fair_limit", .slot = at<t, &T::fair_limit>, .commands = choosing,
         .help = "Fairing moves no control point farther than this.", .unit = "mm", .min = 0,
         .zero = "a thousandth of the line's length"},
        {.section = "target", .name = "on_surface", .slot = at<t, &T::on_surface>, .commands = choosing,
         .help = "Drop the target line onto the model."},
        {.section = "target", .name = "correspondence", .slot = at<t, &T::correspondence>, .commands = moving,
         .help = "How vertices of the line find their goal: nearest point of the target, or equal arc length.",
         .choices = {"projection", "arc-length"}},
    });
}

void add_region_options(std::vector<Option>& table)
{
    using R = RegionSettings;
    constexpr auto r = &Job::region;
    table.insert(table.end(), {
        {.section = "region", .name = "roi_distance", .slot = at<r, &R::roi_distance>, .commands = moving,
         .help = "Half-width of the region around line and target, along the surface.", .unit = "mm", .min = 0,
         .zero = "from the line's length and the size of the move"},
        {.section = "region", .name = "roi_faces", .slot = at<r, &R::roi_faces>, .commands = moving,
         .help = "Region by numbers of CAD faces instead of a distance.", .min = 0, .max = 1e9},
        {.section = "region", .name = "roi_lines", .slot = at<r, &R::roi_lines>, .commands = moving,
         .help = "Region by bounding lines instead of a distance: feature lines or files of vertex indices."},
        {.section = "region", .name = "roi_box", .slot = at<r, &R::roi_box>, .commands = moving,
         .help = "Region by a box instead of a distance: xmin, ymin, zmin, xmax, ymax, zmax.", .unit = "mm",
         .count = 6},
        {.section = "region", .name = "free_borders", .slot = at<r, &R::free_borders>, .commands = moving,
         .help = "Let open borders of the model inside the region move."},
        {.section = "region", .name = "fixed_vertices", .slot = at<r, &R::fixed_vertices>, .commands = moving,
         .help = "Vertices of the input inside the region that stay where they are.", .min = 0, .max = 2147483647},
        {.section = "region", .name = "fixed_faces", .slot = at<r, &R::fixed_faces>, .commands = moving,
         .help = "CAD faces inside the region that stay where they are, by their numbers.", .min = 0, .max = 1e9},
        {.section = "region", .name = "keep", .slot = at<r, &R::keep>, .commands = moving,
         .help = "Other lines that stay lines where the surface makes room, however blunt they are and wherever the "
                 "target goes: their vertices slide along them. Feature lines or files of vertex indices."},
        {.section = "region", .name = "hold", .slot = at<r, &R::hold>, .commands = moving,
         .help = "Other lines whose vertices stay where they are. Feature lines or files of vertex indices."},
    });
}

void add_move_options(std::vector<Option>& table)
{
    using M = MoveSettings;
    constexpr auto m = &Job::move;
    table.insert(table.end(), {
        {.section = "move", .name = "method", .slot = at<m, &M::method>, .commands = moving,
         .help = "Deformation method.", .choices = method_names()},
        {.section = "move", .name = "retraction", .slot = at<m, &M::retraction>, .commands = moving,
         .help = "How the compressed side makes room.", .choices = {"auto", "harmonic", "planes", "sequential"}},
        {.section = "move", .name = "active_radius", .slot = at<m, &M::active_radius>, .commands = moving,
         .help = "Sequential retraction: how far a sliding vertex drags others along.", .unit = "mm", .min = 0,
         .zero = "up to the nearest fixed vertex"},
        {.section = "move", .name = "extension_path", .slot = at<m, &M::extension_path>, .commands = moving,
         .help = "How the line is prolonged to the region's rim: straight through triangles, or along edges.",
         .choices = {"geodesic", "edges"}},
        {.section = "move", .name = "extension_target", .slot = at<m, &M::extension_target>, .commands = moving,
         .help = "Where the prolongation goes: fading to zero at the rim, or free.",
         .choices = {"auto", "tapered", "free"}},
        {.section = "move", .name = "end_slide", .slot = at<m, &M::end_slide>, .commands = moving,
         .help = "How far the moved line's ends may slide along their target, giving up its last piece to a smoother "
                 "prolongation.",
         .unit = "mm", .min = 0},
        {.section = "move", .name = "stiffness_ratio", .slot = at<m, &M::stiffness_ratio>, .commands = moving,
         .help = "Stiffness along against across; 1 is isotropic.", .min = 1, .max = 1e6},
        {.section = "move", .name = "stiff", .slot = at<m, &M::stiff>, .commands = moving,
         .help = "Which direction is the stiff one, relative to the move.", .choices = {"auto", "along", "across"}},
        {.section = "move", .name = "placement", .slot = at<m, &M::placement>, .commands = moving,
         .help = "Whether the line stays on the surface; auto measures it.",
         .choices = {"auto", "on-surface", "off-surface"}},
        {.section = "move", .name = "compressed_side", .slot = at<m, &M::compressed_side>,
         .commands = moving | check_command, .help = "The side that gives way; auto measures it.",
         .choices = {"auto", "left", "right"}},
        {.section = "move", .name = "restore_crease", .slot = at<m, &M::restore_crease>, .commands = moving,
         .help = "Bring back the crease angle along the moved line; auto does so when it was lost.",
         .choices = {"auto", "on", "off"}},
        {.section = "move", .name = "crease_loss", .slot = at<m, &M::crease_loss>, .commands = moving,
         .help = "A crease angle that fell below this share of the original's counts as lost.", .min = 0, .max = 1},
        {.section = "move", .name = "solver_tolerance", .slot = at<m, &M::solver_tolerance>, .commands = moving,
         .help = "Largest error of a vertex at which the solver may stop.", .unit = "mm", .min = 0,
         .zero = "a hundred-thousandth of the region's diagonal"},
        {.section = "move", .name = "max_iterations", .slot = at<m, &M::max_iterations>, .commands = moving,
         .help = "Solver iterations after which the move counts as not converged.", .min = 1, .max = 10000000},
        {.section = "move", .name = "rim", .slot = at<m, &M::rim>, .commands = moving,
         .help = "What is kept where the region ends, beside the place: the tangent plane, or only the place; auto: "
                 "the tangent plane but on open borders and creases, and asan-fl-paper and the methods that do not cut "
                 "the region as they are.",
         .choices = {"auto", "position", "tangent"}},
        {.section = "move", .name = "rim_width", .slot = at<m, &M::rim_width>, .commands = moving,
         .help = "Width of the band inside the region over which the tangent plane at its rim is brought about.",
         .unit = "mm", .min = 0, .zero = "a third of the way to the line; plate-fl: all of it"},
        {.section = "move", .name = "crease", .slot = at<m, &M::crease>, .commands = moving,
         .help = "plate-fl: what becomes of the crease along the moved line: free for sections with one sign of "
                 "curvature, or keep the angle.",
         .choices = {"free", "keep"}},
        {.section = "move", .name = "plate_stiffness_ratio", .slot = at<m, &M::plate_stiffness_ratio>,
         .commands = moving, .help = "plate-fl: bending stiffness along the move against across; 1 is isotropic.",
         .min = 0, .max = 1e6, .zero = "3; with crease keep 1, and 0.5 in the side that holds the angle"},
        {.section = "move", .name = "exact_surface", .slot = at<m, &M::exact_surface>, .commands = moving,
         .help = "CAD input: the side that gives way ends on the exact faces (auto), or on their triangles (off).",
         .choices = {"auto", "off"}},
        {.section = "move", .name = "strip", .slot = at<m, &M::strip>, .commands = choosing,
         .help = "plate-fl, asan-fl: a narrow bend beside the line is carried along with it as a piece, where the "
                 "curvature shows one (auto), or slid over (none).",
         .choices = {"auto", "none"}},
        {.section = "move", .name = "strip_width", .slot = at<m, &M::strip_width>, .commands = choosing,
         .help = "Width of the strips carried along on both sides of the line, whatever the curvature.", .unit = "mm",
         .min = 0, .zero = "by the curvature beside the line"},
        {.section = "move", .name = "clamp_rings", .slot = at<m, &M::clamp_rings>, .commands = moving,
         .help = "Rings of triangles outside the region that hold its slope at the rim.", .min = 0, .max = 2},
        {.section = "move", .name = "rings", .slot = at<m, &M::rings>, .commands = moving,
         .help = "arap-n: how many rings of triangles around a vertex share its rotation.", .min = 0, .max = 1e6,
         .zero = "the whole region"},
        {.section = "move", .name = "ring_weights", .slot = at<m, &M::ring_weights>, .commands = moving,
         .help = "arap-n: every triangle counts the same, or once for each ring it is in.",
         .choices = {"even", "by-cell"}},
        {.section = "move", .name = "smoothness", .slot = at<m, &M::smoothness>, .commands = moving,
         .help = "sr-arap: how strongly neighbouring rotations are held together.", .min = 0, .max = 1e6},
        {.section = "move", .name = "check_unique", .slot = at<m, &M::check_unique>,
         .commands = moving | compare_command,
         .help = "Solve from a second start too and report how far apart the answers end; more than 0.1 mm (or a "
                 "ten-thousandth of a small region) is ambiguous."},
        {.section = "move", .name = "allow_ambiguous", .slot = at<m, &M::allow_ambiguous>, .commands = moving,
         .help = "Write the result even when it is ambiguous."},
        {.section = "move", .name = "allow_unconverged", .slot = at<m, &M::allow_unconverged>, .commands = moving,
         .help = "Write the result even when the solver did not reach its tolerance."},
    });
}

void add_output_options(std::vector<Option>& table)
{
    using O = OutputSettings;
    constexpr auto o = &Job::outputs;
    constexpr FileRole output = FileRole::output;
    table.insert(table.end(), {
        {.section = "outputs", .name = "out", .slot = at<o, &O::out>, .commands = mesh_command | moving,
         .help = "Mesh to write, by its ending: .obj, .stl, .ply or .off; may be given several times.", .file = output,
         .required = moving, .letter = "o"},
        {.section = "outputs", .name = "rest", .slot = at<o, &O::rest>, .commands = moving,
         .help = "Mesh before the move with the same vertices and triangles as the result.", .file = output},
        {.section = "outputs", .name = "stats", .slot = at<o, &O::stats>, .commands = moving,
         .help = "JSON file with everything that was done and measured.", .file = output},
        {.section = "outputs", .name = "report", .slot = at<o, &O::report>, .commands = moving,
         .help = "One HTML page with the numbers and pictures.", .file = output},
        {.section = "outputs", .name = "pictures", .slot = at<o, &O::pictures>, .commands = moving,
         .help = "Folder for pictures before and after: shaded, zebra, curvature sign, sections.", .file = output},
        {.section = "outputs", .name = "line_vertices", .slot = at<o, &O::line_vertices>, .commands = moving,
         .help = "File for the moved line's vertex indices in the result, one a line.", .file = output},
        {.section = "outputs", .name = "save_target", .slot = at<o, &O::save_target>, .commands = moving,
         .help = "File for the target line that was used: .json, .step, .iges, .brep or .csv.", .file = output},
        {.section = "outputs", .name = "ascii", .slot = at<o, &O::ascii>, .commands = mesh_command | moving,
         .help = "Write STL and PLY as text."},
    });
}

void add_gate_options(std::vector<Option>& table)
{
    using G = GateSettings;
    constexpr auto g = &Job::gate;
    table.insert(table.end(), {
        {.section = "gate", .name = "max_bulge", .slot = at<g, &G::max_bulge>, .commands = gating,
         .help = "Fail when the compressed side leaves its old surface by more.", .unit = "mm", .min = 0},
        {.section = "gate", .name = "max_inflections", .slot = at<g, &G::max_inflections>, .commands = gating,
         .help = "Fail when a section of the compressed side has more new inflections.", .min = 0},
        {.section = "gate", .name = "max_turning_increase", .slot = at<g, &G::max_turning_increase>, .commands = gating,
         .help = "Fail when a section of the compressed side turns by more than before plus this.",
         .unit = "deg", .min = 0},
        {.section = "gate", .name = "min_squash", .slot = at<g, &G::min_squash>, .commands = gating,
         .help = "Fail when triangles at the line keep less than this share of their width.", .min = 0, .max = 1},
        {.section = "gate", .name = "max_flipped", .slot = at<g, &G::max_flipped>, .commands = gating,
         .help = "Fail when more triangles are turned over.", .min = 0},
        {.section = "gate", .name = "max_line_error", .slot = at<g, &G::max_line_error>, .commands = gating,
         .help = "Fail when a vertex of the moved line misses the target by more.", .unit = "mm", .min = 0},
        {.section = "gate", .name = "max_crease_change", .slot = at<g, &G::max_crease_change>, .commands = gating,
         .help = "Fail when the crease angle changes by more somewhere along the line.", .unit = "deg", .min = 0},
    });
}

void add_command_options(std::vector<Option>& table)
{
    using C = CommandSettings;
    constexpr auto c = &Job::command;
    constexpr std::string_view s = "command";
    table.insert(table.end(), {
        {.section = s, .name = "job", .slot = at<c, &C::job>, .commands = run_command | compare_command,
         .help = "Job file (JSON).", .file = FileRole::input, .required = run_command | compare_command,
         .operand = true},
        {.section = s, .name = "out", .slot = at<c, &C::out_target>, .commands = target_command,
         .help = "Target line to write: .json, .step, .iges, .brep or .csv.", .file = FileRole::output,
         .required = target_command, .letter = "o"},
        {.section = s, .name = "out", .slot = at<c, &C::out_folder>, .commands = compare_command,
         .help = "Folder for compare.html, compare.json, one mesh a method and the pictures.", .file = FileRole::output,
         .required = compare_command, .letter = "o"},
        {.section = s, .name = "methods", .slot = at<c, &C::methods>, .commands = compare_command,
         .help = "The methods to compare.", .choices = method_names(), .zero = "all"},
        {.section = s, .name = "json", .slot = at<c, &C::json>,
         .commands = mesh_command | lines_command | check_command,
         .help = "Write the answer as JSON to a file, or to standard output for -.", .file = FileRole::output},
        {.section = s, .name = "picture", .slot = at<c, &C::picture>, .commands = lines_command,
         .help = "PNG of the model with its numbered lines.", .file = FileRole::output},
        {.section = s, .name = "save_job", .slot = at<c, &C::save_job>, .commands = move_command,
         .help = "Write the job file that repeats this command.", .file = FileRole::output},
        {.section = s, .name = "against", .slot = at<c, &C::against>, .commands = check_command,
         .help = "The model before the move.", .file = FileRole::input, .required = check_command},
        {.section = s, .name = "line_vertices", .slot = at<c, &C::line_vertices>, .commands = check_command,
         .help = "File of the moved line's vertex indices, as move writes it.", .file = FileRole::input},
        {.section = s, .name = "stats", .slot = at<c, &C::stats>, .commands = check_command,
         .help = "The move's statistics, for its line, its compressed side and its added vertices.",
         .file = FileRole::input},
        {.section = s, .name = "threads", .slot = at<c, &C::threads>, .commands = all_commands,
         .help = "Threads to use; results do not depend on it.", .min = 0, .max = 1024, .zero = "all processors"},
        {.section = s, .name = "quiet", .slot = at<c, &C::quiet>, .commands = all_commands,
         .help = "Only errors on standard error.", .letter = "q"},
        {.section = s, .name = "progress", .slot = at<c, &C::progress>, .commands = all_commands,
         .help = "How to show progress on standard error; auto is a bar on a terminal, json a line a step.",
         .choices = {"auto", "bar", "json", "none"}},
    });
}

// clang-format on

std::vector<Option> make_table()
{
    std::vector<Option> table;
    add_model_options(table);
    add_line_options(table);
    add_target_options(table);
    add_region_options(table);
    add_move_options(table);
    add_output_options(table);
    add_gate_options(table);
    add_command_options(table);
    return table;
}

} // namespace

bool LineSelector::names_line() const
{
    const std::string_view number(text.data(), std::min(text.find('@'), text.size()));
    return !number.empty() && std::ranges::all_of(number, [](unsigned char c) { return std::isdigit(c); });
}

std::string Option::path() const
{
    return section.empty() ? std::string(name) : std::string(section) + "." + std::string(name);
}

std::string Option::flag() const
{
    std::string flag = "--" + std::string(name);
    std::ranges::replace(flag, '_', '-');
    return flag;
}

std::span<const Option> option_table()
{
    static const std::vector<Option> table = make_table();
    return table;
}

std::span<const OptionSection> option_sections()
{
    static constexpr std::array<OptionSection, 8> sections = {
        {{"import", "How the model is read."},
         {"remesh", "Even triangles in the region."},
         {"lines", "Which feature line moves, and how lines are found."},
         {"target", "Where the line goes."},
         {"region", "What may move with it."},
         {"move", "How the surface follows."},
         {"outputs", "What is written, relative to the job file."},
         {"gate", "Limits on the result; a miss ends with exit code 5."}}};
    return sections;
}

} // namespace tapeline
