// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugin/runner/html_report.h"

#include <fmt/format.h>

namespace tapeline {

namespace {

constexpr std::string_view style = "body{font:15px/1.5 sans-serif;max-width:1240px;margin:2em auto;padding:0 1em}"
                                   "pre{background:#f4f4f2;padding:1em;overflow-x:auto}"
                                   ".pair{display:flex;flex-wrap:wrap;gap:12px}figure{margin:0;flex:1 1 560px}"
                                   "img{width:100%}figcaption{color:#555}";

} // namespace

std::string html_text(std::string_view text)
{
    std::string safe;
    for (const char c : text) {
        switch (c) {
        case '&':
            safe += "&amp;";
            break;
        case '<':
            safe += "&lt;";
            break;
        case '>':
            safe += "&gt;";
            break;
        case '"':
            safe += "&quot;";
            break;
        default:
            safe += c;
        }
    }
    return safe;
}

std::string base64(std::string_view bytes)
{
    static constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t k = 0; k < bytes.size(); k += 3) {
        unsigned group = 0;
        for (std::size_t j = 0; j < 3; ++j) {
            group = group << 8U | (k + j < bytes.size() ? static_cast<unsigned char>(bytes[k + j]) : 0U);
        }
        for (std::size_t j = 0; j < 4; ++j) {
            text += k + j <= bytes.size() ? digits[group >> (18 - 6 * j) & 63U] : '=';
        }
    }
    return text;
}

std::string html_report(const Job& job, const JobOutcome& outcome, const std::vector<Picture>& pictures)
{
    const std::string title = fmt::format("Tapeline: {}", job.input.filename().string());
    std::string page = fmt::format("<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title>"
                                   "<style>{1}</style></head><body>\n<h1>{0}</h1>\n",
                                   html_text(title), style);
    if (!job.description.empty()) {
        page += fmt::format("<p>{}</p>\n", html_text(job.description));
    }
    page += fmt::format("<h2>The move</h2>\n<pre>{}</pre>\n", html_text(outcome_table(outcome)));
    page += fmt::format("<h2>Measures</h2>\n<pre>{}</pre>\n", html_text(measures_table(outcome.measures)));
    if (!outcome.warnings.empty()) {
        page += "<h2>Warnings</h2>\n<ul>\n";
        for (const std::string& warning : outcome.warnings) {
            page += fmt::format("<li>{}</li>\n", html_text(warning));
        }
        page += "</ul>\n";
    }
    page += "<h2>Pictures</h2>\n<div class=\"pair\">\n";
    for (const Picture& picture : pictures) {
        page += fmt::format("<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\"><figcaption>{0}</figcaption>"
                            "</figure>\n",
                            html_text(picture.title), base64(picture.png));
    }
    return page + fmt::format("</div>\n<p>tapeline {}, input SHA-256 {}</p>\n</body></html>\n", version(),
                              outcome.input_sha256);
}

} // namespace tapeline
