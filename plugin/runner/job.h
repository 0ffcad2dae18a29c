// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tapeline {

/// How a person names a chain of vertices: "ID" or "ID@FROM..TO" of a feature line, or a file of vertex indices.
struct LineSelector {
    std::string text;
    bool empty() const { return text.empty(); }
    /// True when the text starts like a line number; otherwise it is the name of a file.
    bool names_line() const;
    bool operator==(const LineSelector&) const = default;
};

struct ImportSettings {
    std::string units = "mm";
    double linear_deflection = 0;
    double angular_deflection = 5;
    double sew_tolerance = 0;
};

struct RemeshSettings {
    std::string remesh = "auto";
    double max_edge = 0;
};

struct LineSettings {
    LineSelector line;
    double crease_angle = 10;
    double crease_angle_low = 5;
    double max_turn = 60;
    double min_length = 0;
};

struct TargetSettings {
    std::filesystem::path target;
    int control_points = 0;
    double tolerance = 0;
    int surface_points = 0;
    std::filesystem::path edit;
    std::vector<double> slide;
    bool fair = false;
    double fair_limit = 0;
    bool on_surface = false;
    std::string correspondence = "projection";
};

struct RegionSettings {
    double roi_distance = 0;
    std::vector<int> roi_faces;
    std::vector<LineSelector> roi_lines;
    std::vector<double> roi_box;
    bool free_borders = false;
    std::vector<int> fixed_vertices;
    std::vector<int> fixed_faces;
    std::vector<LineSelector> keep;
    std::vector<LineSelector> hold;
};

struct MoveSettings {
    std::string method = "plate-fl";
    std::string retraction = "auto";
    std::string extension_path = "geodesic";
    std::string extension_target = "auto";
    double end_slide = 0;
    double stiffness_ratio = 100;
    std::string stiff = "auto";
    std::string placement = "auto";
    std::string compressed_side = "auto";
    std::string restore_crease = "auto";
    double crease_loss = 0.5;
    double solver_tolerance = 0;
    int max_iterations = 2000;
    int clamp_rings = 1;
    double active_radius = 0;
    int rings = 20;
    std::string ring_weights = "even";
    double smoothness = 0.02;
    bool check_unique = false;
    bool allow_ambiguous = false;
    std::string rim = "auto";
    double rim_width = 0;
    std::string crease = "free";
    double plate_stiffness_ratio = 0;
    std::string exact_surface = "auto";
    std::string strip = "auto";
    double strip_width = 0;
    bool allow_unconverged = false;
};

struct OutputSettings {
    std::vector<std::filesystem::path> out;
    std::filesystem::path rest;
    std::filesystem::path stats;
    std::filesystem::path report;
    std::filesystem::path pictures;
    std::filesystem::path line_vertices;
    std::filesystem::path save_target;
    bool ascii = false;
};

struct GateSettings {
    std::optional<double> max_bulge;
    std::optional<double> max_inflections;
    std::optional<double> max_turning_increase;
    std::optional<double> min_squash;
    std::optional<double> max_flipped;
    std::optional<double> max_line_error;
    std::optional<double> max_crease_change;
};

/// What single commands need beyond a job; never part of a job file.
struct CommandSettings {
    std::filesystem::path job;
    std::filesystem::path out_target;
    std::filesystem::path out_folder;
    std::vector<std::string> methods;
    std::filesystem::path json;
    std::filesystem::path picture;
    std::filesystem::path save_job;
    std::filesystem::path against;
    std::filesystem::path line_vertices;
    std::filesystem::path stats;
    int threads = 0;
    bool quiet = false;
    std::string progress = "auto";
};

/// One job from start to end: everything that a job file or a command line can say. The default values here are the
/// defaults everywhere; names, ranges and help stand in the option table (plugin/runner/options.h).
struct Job {
    std::string description;
    std::filesystem::path input;
    ImportSettings import;
    RemeshSettings remesh;
    LineSettings lines;
    TargetSettings target;
    RegionSettings region;
    MoveSettings move;
    OutputSettings outputs;
    GateSettings gate;
    CommandSettings command;
};

} // namespace tapeline
