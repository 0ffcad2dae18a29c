// SPDX-License-Identifier: GPL-3.0-or-later
// The option table is what flags, job keys and the schema are made from, so it is checked as data.
#include "plugin/runner/job_file.h"
#include "plugin/runner/option_value.h"
#include "tests/plugin/run_command.h"

#include <gtest/gtest.h>
#include <map>
#include <set>

namespace tapeline::testing {
namespace {

using nlohmann::json;

TEST(Options, HaveOneFlagOfANamePerCommand)
{
    for (const unsigned command : {1U, 2U, 4U, 8U, 16U, 32U, 64U}) {
        std::set<std::string> flags;
        for (const Option& option : option_table()) {
            if ((option.commands & command) != 0) {
                EXPECT_TRUE(flags.insert(option.flag()).second) << option.flag() << " twice in command " << command;
            }
        }
        EXPECT_FALSE(flags.empty());
    }
}

TEST(Options, HaveOneJobKeyOfANamePerSection)
{
    std::set<std::string> keys;
    for (const Option& option : option_table()) {
        if (option.in_job()) {
            EXPECT_TRUE(keys.insert(option.path()).second) << option.path();
        }
    }
}

TEST(Options, LiveInPlacesOfTheirOwn)
{
    Job job;
    std::set<const void*> places;
    for (const Option& option : option_table()) {
        const void* place = std::visit([](auto* slot) -> const void* { return slot; }, option.slot(job));
        EXPECT_TRUE(places.insert(place).second) << option.path();
    }
}

TEST(Options, AreExplainedInOneSentence)
{
    for (const Option& option : option_table()) {
        EXPECT_GT(option.help.size(), 10U) << option.path();
        EXPECT_TRUE(option.help.ends_with(".")) << option.path();
    }
}

TEST(Options, AcceptTheirOwnDefaults)
{
    for (const Option& option : option_table()) {
        const json value = option_default(option);
        const bool unset = value.is_null() || (option.count > 0 && value.empty());
        Job job;
        if (!unset) {
            const auto done = set_option(option, job, value, option.path());
            EXPECT_TRUE(done) << (done ? "" : done.error().message);
        }
    }
}

TEST(Options, RefuseNumbersOutsideTheirRange)
{
    int checked = 0;
    for (const Option& option : option_table()) {
        Job job;
        for (const double outside : {option.min - 1, option.max + 1}) {
            if (std::isfinite(outside)) {
                const auto done = set_option(option, job, json::array({outside}).front(), "here");
                EXPECT_FALSE(done) << option.path() << " took " << outside;
                ++checked;
            }
        }
    }
    EXPECT_GT(checked, 20);
}

TEST(Options, ReadNumbersAndListsFromText)
{
    std::map<std::string, const Option*> options;
    for (const Option& option : option_table()) {
        options[option.path()] = &option;
    }
    Job job;
    ASSERT_TRUE(set_option_from_text(*options["target.slide"], job, {"-1.5,0,2e1"}, "--slide"));
    EXPECT_EQ(job.target.slide, (std::vector<double>{-1.5, 0, 20}));
    ASSERT_TRUE(set_option_from_text(*options["region.roi_faces"], job, {"3", "4,5"}, "--roi-faces"));
    EXPECT_EQ(job.region.roi_faces, (std::vector<int>{3, 4, 5}));
    EXPECT_FALSE(set_option_from_text(*options["remesh.max_edge"], job, {"1mm"}, "--max-edge"));
    EXPECT_FALSE(set_option_from_text(*options["remesh.max_edge"], job, {"nan"}, "--max-edge"));
    EXPECT_FALSE(set_option_from_text(*options["remesh.max_edge"], job, {""}, "--max-edge"));
    EXPECT_FALSE(set_option_from_text(*options["move.clamp_rings"], job, {"1.5"}, "--clamp-rings"));
    EXPECT_FALSE(set_option_from_text(*options["region.roi_box"], job, {"1,2,3"}, "--roi-box"));
}

TEST(Schema, IsTheCommittedOne)
{
    const std::string committed = read_text(TAPELINE_SOURCE_DIR "/resources/schema/job.schema.json");
    EXPECT_EQ(committed, job_schema()) << "renew it: tapeline schema > resources/schema/job.schema.json";
}

TEST(Schema, KnowsEveryJobKeyAndNoOther)
{
    const json schema = json::parse(job_schema());
    std::set<std::string> in_schema, in_table;
    for (const auto& [name, property] : schema["properties"].items()) {
        if (property.contains("properties")) {
            EXPECT_FALSE(property["additionalProperties"].get<bool>());
            for (const auto& [key, unused] : property["properties"].items()) {
                in_schema.insert(name + "." + key);
            }
        } else if (name != "$schema") {
            in_schema.insert(name);
        }
    }
    for (const Option& option : option_table()) {
        if (option.in_job()) {
            in_table.insert(option.path());
        }
    }
    EXPECT_EQ(in_schema, in_table);
}

} // namespace
} // namespace tapeline::testing
