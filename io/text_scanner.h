// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/mesh.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace tapeline {

/// What the mesh readers throw among themselves; `read_mesh` turns it into one sentence with the file and the place.
struct ParseError {
    std::size_t at = 0;        ///< byte of the file where the trouble is
    std::string message;       ///< what is wrong and the remedy, without the place
    bool place_is_line = true; ///< text files name the line, binary ones the byte
};

/// A piece of a file made fit for a message: at most 40 characters, nothing unprintable, in quotes.
std::string in_quotes(std::string_view text);

/// Number of the line (from 1) that holds byte `at`; LF, CRLF and CR all end a line.
std::size_t line_number(std::string_view text, std::size_t at);

/// Takes the next blank-separated word off the front of `line`; empty where there is none. A word that starts with #
/// is a comment and takes the rest of the line with it.
std::string_view take_word(std::string_view& line);

/// Walks through a text file line by line and gives numbers, with the place of every failure. Locale independent.
/// All members throw ParseError.
class TextScanner {
public:
    /// Starts at byte `start`, the first of a line.
    explicit TextScanner(std::string_view text, std::size_t start = 0) : text_(text), start_(start), next_(start) {}

    /// Moves to the next line and gives it without its end, false when the text is over. LF, CRLF and CR may mix.
    bool next_line(std::string_view& line);
    /// The next line that holds a word; its leading blanks are gone.
    bool next_filled_line(std::string_view& line);

    std::string_view text() const { return text_; }
    /// First byte that `next_line` has not given yet.
    std::size_t position() const { return next_; }
    /// First byte of the current line.
    std::size_t line_start() const { return start_; }
    std::size_t bytes_left() const { return text_.size() - next_; }

    /// The whole word as a number: 1, +1.0, .5, 2., 1e5. Infinite or absent values and other spellings fail.
    double number(std::string_view word, std::string_view meaning) const;
    std::int64_t integer(std::string_view word, std::string_view meaning) const;
    /// Takes three numbers off the line as the coordinates of vertex `index` (from 0).
    Vec3 point(std::string_view& line, std::size_t index) const;

    [[noreturn]] void fail_here(std::string message) const { throw ParseError{start_, std::move(message)}; }

private:
    std::string_view text_;
    std::size_t start_ = 0, next_ = 0;
    std::size_t line_feed_ = 0; ///< the first LF at or after next_, or the text's size; 0 = not looked for yet
    bool line_feed_known_ = false;
};

} // namespace tapeline
