// Part file: a part while it is made. Each record is appended in one write and is on the disk before the next begins,
// so that whatever ends the program, the file holds whole records and is gone on with from there.
#pragma once

#include "outputs.hpp"
#include "parts.hpp"

#include <string>
#include <vector>

namespace drapeau::lab {

struct PartOptions {
    std::string file;   // "" keeps none
    std::string shard;  // "2/8"; "" is the whole
    bool resume = false;
};

/// The shard asked for. Throws InputError where options do not go together, a shard is asked for what needs all points,
/// or a file may not be written.
Shard checked_shard(const PartOptions& options, const SweepOutputs& outputs);

/// What a shard ends with, on standard output; the exit status.
int say_shard_is_done(const Part& part);

class PartFile {
public:
    /// Begins the file, or with --resume goes on with it if it is there; other processes are kept out of it. While it
    /// is open, signals that end the program say how to go on. Throws InputError for a file that may not be written, is
    /// there already, is no part, or is of another sweep or shard.
    PartFile(const PartOptions& options, const SweepIdentity& sweep, const Shard& shard);
    ~PartFile();
    PartFile(const PartFile&) = delete;
    PartFile& operator=(const PartFile&) = delete;

    /// What it holds.
    const Part& part() const { return part_; }
    bool has(const std::string& key) const { return part_.points.contains(key); }

    /// Throws InputError where what is kept there already is not the same: it was computed otherwise.
    void set_basis(const Json& basis);
    void add(const std::string& key, const Json& cost, const Json& result);
    /// The point timed once more.
    void add_cost(const std::string& key, const Json& cost);

private:
    void append(const std::string& line);

    Part part_;
    int descriptor_ = -1;
};

}  // namespace drapeau::lab
