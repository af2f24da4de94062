#include "extremes/covering.hpp"

#include "extremes/draw.hpp"

#include <numeric>

namespace drapeau::extremes {
namespace {

/// Which pairs are missing yet.
class Pairs {
public:
    explicit Pairs(const std::vector<int>& levels) : first_(levels.size()) {
        for (std::size_t f = 0; f < levels.size(); ++f) first_[f] = all_, all_ += levels[f];
        missing_.assign(static_cast<std::size_t>(all_) * all_, false);
        for (std::size_t a = 0; a < levels.size(); ++a)
            for (std::size_t b = 0; b < a; ++b)
                for (int i = 0; i < levels[a]; ++i)
                    for (int j = 0; j < levels[b]; ++j) set(a, i, b, j, true);
    }
    bool missing(std::size_t a, int i, std::size_t b, int j) const { return missing_[place(a, i, b, j)]; }
    void set(std::size_t a, int i, std::size_t b, int j, bool value) {
        missing_[place(a, i, b, j)] = missing_[place(b, j, a, i)] = value;
    }

private:
    std::size_t place(std::size_t a, int i, std::size_t b, int j) const {
        return static_cast<std::size_t>(first_[a] + i) * all_ + first_[b] + j;
    }
    std::vector<int> first_;
    int all_ = 0;
    std::vector<bool> missing_;
};

constexpr int open = -1;

/// The level of factor f that brings most missing pairs with what the row has; of equals the first, or any.
int best_level(const Pairs& pairs, const Row& row, std::size_t f, int levels, Draw& draw) {
    int best = 0, most = -1, equals = 0;
    const bool first_of_equals = draw.chance(0.5);
    for (int level = 0; level < levels; ++level) {
        int brings = 0;
        for (std::size_t other = 0; other < row.size(); ++other)
            if (other != f && row[other] != open) brings += pairs.missing(f, level, other, row[other]) ? 1 : 0;
        equals = brings > most ? 1 : equals + 1;
        if (brings > most || (brings == most && !first_of_equals && draw.one_of(equals) == 0)) best = level;
        most = std::max(most, brings);
    }
    return best;
}

}  // namespace

std::vector<Row> covering(const std::vector<int>& levels, std::uint64_t seed) {
    Pairs pairs(levels);
    Draw draw{seed, 1};
    std::vector<Row> rows;
    std::vector<std::size_t> order(levels.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t a = 0; a < levels.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
            for (int i = 0; i < levels[a]; ++i)
                for (int j = 0; j < levels[b]; ++j) {
                    if (!pairs.missing(a, i, b, j)) continue;
                    Row row(levels.size(), open);
                    row[a] = i, row[b] = j;
                    for (std::size_t n = order.size(); n > 1; --n)
                        std::swap(order[n - 1], order[static_cast<std::size_t>(draw.one_of(static_cast<int>(n)))]);
                    for (const auto f : order)
                        if (row[f] == open) row[f] = best_level(pairs, row, f, levels[f], draw);
                    for (std::size_t f = 0; f < row.size(); ++f)
                        for (std::size_t g = 0; g < f; ++g) pairs.set(f, row[f], g, row[g], false);
                    rows.push_back(std::move(row));
                }
    return rows;
}

}  // namespace drapeau::extremes
