// Report page: the page itself, from what is said and drawn.
#pragma once

#include <string>
#include <vector>

namespace drapeau::lab {

struct ReportSection {
    std::string title, question;  // "Speed against accuracy", and what it answers
    std::string command;          // as somebody would type it
    std::string picture;          // an SVG; "" where there is none
    std::string text;             // tables, as the command prints them
    std::string trouble;          // why there are none; "" where there are
};

struct ReportPage {
    std::string scene;                 // its name
    std::vector<std::string> answers;  // a sentence each
    std::vector<ReportSection> sections;
    std::string settings;              // the scene as a file
    std::vector<std::string> machine;  // a line each
};

/// One file of HTML without links to others.
std::string html_of(const ReportPage& page);

}  // namespace drapeau::lab
