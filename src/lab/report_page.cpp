#include "report_page.hpp"

#include <string_view>

namespace drapeau::lab {

namespace {

constexpr std::string_view style =
    "body{font:16px/1.5 'DejaVu Sans',Verdana,sans-serif;color:#1d2733;background:#fff;max-width:62rem;margin:2rem "
    "auto;"
    "padding:0 1.5rem}h1{font-size:1.7rem;line-height:1.25}h2{font-size:1.25rem;margin-top:2.6rem;border-top:1px solid "
    "#d7dde4;padding-top:1.2rem}.question{color:#566373;margin-top:-.6rem}.answers li{margin:.45rem "
    "0}pre{font:12.5px/1.45 "
    "'DejaVu Sans Mono',Menlo,monospace;background:#f4f6f8;border-radius:6px;padding:.8rem 1rem;overflow-x:auto}"
    "figure{margin:1rem 0}svg{max-width:100%;height:auto}.trouble{border-left:4px solid #d55e00;padding-left:.8rem}"
    "@media "
    "print{body{margin:0;max-width:none}pre{white-space:pre-wrap}h2{break-after:avoid}figure{break-inside:avoid}}";

std::string escaped(std::string_view text) {
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

/// The drawing alone: what stands before it is of files.
std::string_view drawing_in(std::string_view svg) {
    const auto begin = svg.find("<svg");
    return begin == std::string_view::npos ? "" : svg.substr(begin);
}

/// Names within a drawing, made different from those of the other drawings on the page.
std::string with_own_names(std::string svg, const std::string& prefix) {
    for (const std::string_view before : {"id='", "id=\"", "url(#", "href='#", "href=\"#"}) {
        for (auto at = svg.find(before); at != std::string::npos; at = svg.find(before, at + 1))
            svg.insert(at + before.size(), prefix);
    }
    return svg;
}

std::string html_of(const ReportSection& section, const std::string& prefix) {
    std::string html = "<section>\n<h2>" + escaped(section.title) + "</h2>\n<p class=\"question\">" +
                       escaped(section.question) + "</p>\n";
    if (!section.trouble.empty()) html += "<p class=\"trouble\">" + escaped(section.trouble) + "</p>\n";
    if (const auto drawing = drawing_in(section.picture); !drawing.empty())
        html += "<figure>\n" + with_own_names(std::string(drawing), prefix) + "\n</figure>\n";
    html += "<pre>$ " + escaped(section.command) + "\n" + (section.text.empty() ? "" : "\n" + escaped(section.text)) +
            "</pre>\n";
    return html + "</section>\n";
}

}  // namespace

std::string html_of(const ReportPage& page) {
    std::string html =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
        "content=\"width=device-width, initial-scale=1\">\n<title>" +
        escaped(page.scene) + ": speed and accuracy</title>\n<style>" + std::string(style) +
        "</style>\n</head>\n<body>\n<h1>" + escaped(page.scene) +
        ": what accuracy costs</h1>\n<ul class=\"answers\">\n";
    for (const std::string& answer : page.answers) html += "<li>" + escaped(answer) + "</li>\n";
    html += "</ul>\n";
    for (std::size_t n = 0; n < page.sections.size(); ++n)
        html += html_of(page.sections[n], "p" + std::to_string(n) + "_");
    html += "<section>\n<h2>The scene</h2>\n<pre>" + escaped(page.settings) + "</pre>\n</section>\n";
    html += "<section>\n<h2>The machine</h2>\n<ul>\n";
    for (const std::string& line : page.machine) html += "<li>" + escaped(line) + "</li>\n";
    return html + "</ul>\n</section>\n</body>\n</html>\n";
}

}  // namespace drapeau::lab
