// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/comparison.h"

#include "plugin/runner/guard.h"
#include "plugin/runner/runner.h"
#include "plugin/runner/sha256.h"
#include "plugin/runner/threads.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <fmt/format.h>
#include <mutex>
#include <tbb/parallel_for.h>
#include <thread>

namespace tapeline {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Runs one method; everything that goes wrong stands in the run.
MethodRun run_method(const Preparation& p, const Job& job, const std::string& method, const Progress& progress)
{
    MethodRun run;
    run.method = method;
    const Job own = method_job(job, method);
    const auto start = Clock::now();
    Result<MoveResult> moved = guarded(
        [&] { return move_feature_line(p.model, p.line, p.target->line, p.region, move_options(own), progress); });
    run.seconds = seconds_since(start);
    if (!moved) {
        run.failure = moved.error();
        return run;
    }
    Result<Measures> measured = guarded([&] { return measure_move(*moved, p.target->line); });
    if (!measured) {
        run.failure = measured.error();
        return run;
    }
    run.move = std::move(*moved);
    run.measures = std::move(*measured);
    run.inner_lines = measure_inner_lines(*run.move, p.lines);
    run.gates = evaluate_gates(job.gate, run.measures);
    if (!run.move->converged()) {
        run.failure = not_converged(*run.move);
    } else if (run.move->ambiguous()) {
        run.failure = ambiguity(*run.move);
    }
    return run;
}

/// Lets worker threads run the methods while the caller's thread alone reports progress and learns of a cancellation.
class Crew {
public:
    Crew(std::size_t count, Progress progress) : fractions_(count), progress_(std::move(progress)) {}

    /// Calls work(k, progress) for every k < count, on `threads` threads in all and shares of `threads_each`.
    template <class Work>
    bool run(int threads, int threads_each, const Work& work)
    {
        std::thread boss([&] {
            on_threads(threads, [&] {
                tbb::parallel_for(
                    tbb::blocked_range<int>(0, static_cast<int>(fractions_.size()), 1),
                    [&](const tbb::blocked_range<int>& range) {
                        for (int k = range.begin(); k != range.end(); ++k) {
                            // An arena of its own keeps a waiting method from picking up another one's work.
                            on_threads(threads_each, [&] { work(k, reporter(k)); });
                            fractions_[k] = 1;
                        }
                    },
                    tbb::simple_partitioner());
            });
            const std::lock_guard lock(mutex_);
            done_ = true;
            changed_.notify_one();
        });
        watch();
        boss.join();
        return !cancelled_;
    }

private:
    Progress reporter(int k)
    {
        return Progress([this, k](double fraction, std::string_view) {
            fractions_[k] = fraction;
            return !cancelled_.load();
        });
    }

    void watch()
    {
        std::unique_lock lock(mutex_);
        double shown = 0;
        while (!changed_.wait_for(lock, std::chrono::milliseconds(50), [this] { return done_; })) {
            double sum = 0;
            for (const auto& fraction : fractions_) {
                sum += fraction;
            }
            shown = std::max(shown, sum / static_cast<double>(fractions_.size()));
            if (!progress_.report(shown, "methods")) {
                cancelled_ = true;
            }
        }
    }

    std::vector<std::atomic<double>> fractions_;
    Progress progress_;
    std::atomic<bool> cancelled_{false};
    std::mutex mutex_;
    std::condition_variable changed_;
    bool done_ = false;
};

Result<Comparison> compare_steps(const Job& job, const JobInputs& inputs, const Progress& progress)
{
    Stopwatch watch;
    Comparison made;
    const auto methods = compared_methods(job);
    if (!methods) {
        return tl::unexpected(methods.error());
    }
    auto prepared = prepare(job, watch, progress.part(0.0, 0.2), inputs);
    if (!prepared) {
        return tl::unexpected(prepared.error());
    }
    made.preparation = std::move(*prepared);
    watch.restart();
    const int threads = allowed_threads();
    const auto count = static_cast<int>(methods->size());
    made.threads_per_method = std::max(1, threads / count);
    made.runs.resize(methods->size());
    Crew crew(methods->size(), progress.part(0.2, 1.0));
    const bool finished = crew.run(threads, made.threads_per_method, [&](int k, const Progress& part) {
        made.runs[k] = run_method(made.preparation, job, (*methods)[k], part);
    });
    if (!finished || !progress.report(1.0, "methods")) {
        return fail(ErrorKind::cancelled, "cancelled");
    }
    watch.lap("methods");
    made.ranking = rank_runs(made.runs);
    const Preparation& p = made.preparation;
    for (const auto* warnings : {&p.import.warnings, &p.warnings, &p.target->warnings, &p.region.warnings}) {
        made.warnings.insert(made.warnings.end(), warnings->begin(), warnings->end());
    }
    made.seconds = watch.seconds();
    const auto sha256 = inputs.model ? Result<std::string>(inputs.model->sha256) : file_sha256(job.input);
    return sha256.map([&](std::string sum) {
        made.input_sha256 = std::move(sum);
        return std::move(made);
    });
}

} // namespace

Result<std::vector<std::string>> compared_methods(const Job& job)
{
    std::vector<std::string> methods = job.command.methods;
    if (methods.empty()) {
        for (const MethodInfo& info : method_table()) {
            methods.emplace_back(info.name);
        }
    }
    for (std::size_t k = 1; k < methods.size(); ++k) {
        const auto here = methods.begin() + static_cast<std::ptrdiff_t>(k);
        if (std::find(methods.begin(), here, methods[k]) != here) {
            return fail(ErrorKind::usage, fmt::format("--methods names {} twice", methods[k]));
        }
    }
    return methods;
}

Job method_job(const Job& job, const std::string& method)
{
    Job own = job;
    own.move.method = method;
    if (method != job.move.method) {
        const MoveSettings meant;
        own.move.retraction = meant.retraction;
        own.move.extension_target = meant.extension_target;
        own.move.stiffness_ratio = meant.stiffness_ratio;
        own.move.stiff = meant.stiff;
    }
    return own;
}

Result<Comparison> compare_methods(const Job& job, const Progress& progress, const JobInputs& inputs)
{
    return guarded([&] { return compare_steps(job, inputs, progress); });
}

} // namespace tapeline
