// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/text_scanner.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>

namespace tapeline {

namespace {

constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

} // namespace

std::string in_quotes(std::string_view text)
{
    std::string result = "\"";
    for (const char c : text.substr(0, 40)) {
        result += c >= 32 && c < 127 ? c : '?';
    }
    return result + (text.size() > 40 ? "…\"" : "\"");
}

std::size_t line_number(std::string_view text, std::size_t at)
{
    text = text.substr(0, at);
    std::size_t line = 1;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool pair = text[i] == '\n' && i > 0 && text[i - 1] == '\r';
        line += (text[i] == '\n' || text[i] == '\r') && !pair;
    }
    return line;
}

std::string_view take_word(std::string_view& line)
{
    std::size_t begin = 0;
    while (begin < line.size() && is_blank(line[begin])) {
        ++begin;
    }
    std::size_t end = begin;
    while (end < line.size() && !is_blank(line[end])) {
        ++end;
    }
    if (begin < line.size() && line[begin] == '#') {
        line = {};
        return {};
    }
    const auto word = line.substr(begin, end - begin);
    line.remove_prefix(end);
    return word;
}

bool TextScanner::next_line(std::string_view& line)
{
    if (next_ >= text_.size()) {
        return false;
    }
    start_ = next_;
    // The position of the LF is kept, or a file with CR alone would be searched to its end for every line.
    if (!line_feed_known_ || line_feed_ < start_) {
        line_feed_ = std::min(text_.find('\n', start_), text_.size());
        line_feed_known_ = true;
    }
    line = text_.substr(start_, line_feed_ - start_);
    const auto carriage_return = line.find('\r');
    if (carriage_return == std::string_view::npos) {
        next_ = std::min(line_feed_ + 1, text_.size());
        return true;
    }
    line = line.substr(0, carriage_return);
    next_ = start_ + carriage_return + 1;
    if (next_ == line_feed_ && next_ < text_.size()) {
        ++next_;
    }
    return true;
}

bool TextScanner::next_filled_line(std::string_view& line)
{
    while (next_line(line)) {
        std::string_view rest = line;
        const auto word = take_word(rest);
        if (!word.empty()) {
            line.remove_prefix(static_cast<std::size_t>(word.data() - line.data()));
            return true;
        }
    }
    return false;
}

double TextScanner::number(std::string_view word, std::string_view meaning) const
{
    if (word.empty()) {
        fail_here(fmt::format("{} is missing: the file is damaged or cut off, export the model again", meaning));
    }
    std::string_view digits = word;
    if (digits[0] == '+' && digits.size() > 1 && digits[1] != '-') {
        digits.remove_prefix(1);
    }
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc::result_out_of_range) {
        fail_here(fmt::format("{} is {}, beyond what a double can hold: correct it", meaning, in_quotes(word)));
    }
    if (error != std::errc() || end != digits.data() + digits.size()) {
        fail_here(
            fmt::format("{} is {}, which is not a number of the form 1.5e3: correct it", meaning, in_quotes(word)));
    }
    if (!std::isfinite(value)) {
        fail_here(fmt::format("{} is {}, not a finite number: correct it or export the model again", meaning,
                              in_quotes(word)));
    }
    return value;
}

std::int64_t TextScanner::integer(std::string_view word, std::string_view meaning) const
{
    if (word.empty()) {
        fail_here(fmt::format("{} is missing: the file is damaged or cut off, export the model again", meaning));
    }
    std::string_view digits = word;
    if (digits[0] == '+' && digits.size() > 1 && digits[1] != '-') {
        digits.remove_prefix(1);
    }
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size()) {
        fail_here(fmt::format("{} is {}, which is not a whole number: correct it", meaning, in_quotes(word)));
    }
    return value;
}

Vec3 TextScanner::point(std::string_view& line, std::size_t index) const
{
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) {
        const auto word = take_word(line);
        // The words of the message are put together only where they are needed: this is the inner loop of all readers.
        const bool plain = !word.empty() && word.size() < 32;
        double value = 0;
        const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
        if (plain && result.ec == std::errc() && result.ptr == word.data() + word.size() && std::isfinite(value)) {
            p[axis] = value;
        } else {
            p[axis] = number(word, fmt::format("{} of vertex {} (counted from 0)", "xyz"[axis], index));
        }
    }
    return p;
}

} // namespace tapeline
