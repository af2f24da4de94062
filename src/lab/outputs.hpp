// Outputs: the files a command writes, each with the option that asked for it.
#pragma once

#include "io/output_file.hpp"

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace drapeau::lab {

/// Those that were asked for: "" names none.
inline std::vector<NamedFile> asked_for(const std::vector<NamedFile>& all) {
    std::vector<NamedFile> outputs;
    for (const NamedFile& output : all)
        if (!output.name.empty()) outputs.push_back(output);
    return outputs;
}

/// What a sweep writes; "" writes none.
struct SweepOutputs {
    std::string json, write, plot;
    std::filesystem::path scene_file;  // the scene's own, beside which its image is; "" where that is not known

    std::vector<NamedFile> files() const { return asked_for({{"--write", write}, {"--json", json}, {"--plot", plot}}); }
};

/// Tables go to standard output, unless a file asked for goes there.
inline std::FILE* place_of_table(const std::vector<NamedFile>& outputs) {
    for (const NamedFile& output : outputs)
        if (is_same_file("/dev/stdout", output.name)) return stderr;
    return stdout;
}

}  // namespace drapeau::lab
