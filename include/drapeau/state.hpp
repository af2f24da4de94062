// State: position and velocity of every mass of a grid, owned. The same type serves runs, checkpoints, files, starts
// and what one method or grid hands to the next.
//
// Rows are padded to whole registers, with one more register of zeros behind. Padding stays at zero: it has no mass and
// no spring.
#pragma once

#include "drapeau/field.hpp"
#include "drapeau/isa.hpp"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <new>
#include <utility>

namespace drapeau {
inline namespace DRAPEAU_ISA {

/// The grid at rest: column i, row j at (i * pitch_x, -j * pitch_y, 0), in metres.
struct Grid {
    int columns = 2;
    int rows = 2;
    double pitch_x = 0.1;  // m, between columns
    double pitch_y = 0.1;  // m, between rows

    long long masses() const { return static_cast<long long>(columns) * rows; }
    glm::dvec3 rest(int i, int j) const { return {i * pitch_x, -j * pitch_y, 0.0}; }
    double pitch_diagonal() const { return std::hypot(pitch_x, pitch_y); }
    bool operator==(const Grid&) const = default;
};

/// The grid that spreads `columns` x `rows` masses over width x height (m); a chain ignores the size across.
inline Grid spread(int columns, int rows, double width, double height) {
    return {columns, rows, columns > 1 ? width / (columns - 1) : width, rows > 1 ? height / (rows - 1) : height};
}

/// `count` Reals, all zero at first, aligned for registers, with one register of readable zeros on either side.
template <class Real>
class Array {
public:
    Array() = default;
    explicit Array(std::size_t count, std::size_t shift_bytes = 0)
        : bytes_(
              static_cast<std::byte*>(::operator new(bytes_for(count, shift_bytes), std::align_val_t(row_alignment)))),
          first_(reinterpret_cast<Real*>(bytes_.get() + row_alignment + shift_bytes)),
          count_(count),
          shift_(shift_bytes) {
        std::fill_n(bytes_.get(), bytes_for(count, shift_bytes), std::byte{0});
    }
    Array(const Array& other) : Array(other.count_, other.shift_) { *this = other; }
    Array(Array&& other) noexcept { *this = std::move(other); }
    Array& operator=(const Array& other) {
        if (count_ != other.count_) return *this = Array(other);
        std::copy_n(other.first_, count_, first_);
        return *this;
    }
    Array& operator=(Array&& other) noexcept {
        bytes_ = std::move(other.bytes_);
        first_ = std::exchange(other.first_, nullptr);
        count_ = std::exchange(other.count_, 0);
        shift_ = std::exchange(other.shift_, 0);
        return *this;
    }

    Real* data() { return first_; }
    const Real* data() const { return first_; }
    std::size_t size() const { return count_; }
    Real& operator[](std::size_t n) { return first_[n]; }
    const Real& operator[](std::size_t n) const { return first_[n]; }
    Real* begin() { return first_; }
    Real* end() { return first_ + count_; }
    const Real* begin() const { return first_; }
    const Real* end() const { return first_ + count_; }

private:
    struct Free {
        void operator()(std::byte* bytes) const { ::operator delete(bytes, std::align_val_t(row_alignment)); }
    };
    static std::size_t bytes_for(std::size_t count, std::size_t shift) {
        return count * sizeof(Real) + 2 * row_alignment + shift;
    }

    std::unique_ptr<std::byte, Free> bytes_;
    Real* first_ = nullptr;
    std::size_t count_ = 0, shift_ = 0;
};

/// The widest register's number of Reals.
template <class Real>
inline constexpr int widest = static_cast<int>(row_alignment / sizeof(Real));

/// Columns rounded up to a whole number of the widest registers: what a loop over a row covers.
template <class Real>
constexpr int padded(int columns) {
    return (columns + widest<Real> - 1) / widest<Real> * widest<Real>;
}

/// Elements from one row to the next: a register more than padded, always zero, so that looking one column past the end
/// never meets another row.
template <class Real>
constexpr int stride_of(int columns) {
    return padded<Real>(columns) + widest<Real>;
}

/// A field that owns its memory: rows x stride elements a component.
template <class Real>
class FieldBuffer {
public:
    FieldBuffer() = default;
    /// `number` sets fields of one cloth apart (see component_shift_bytes).
    FieldBuffer(int columns, int rows, int number = 0) : columns_(columns), rows_(rows) {
        for (int c = 0; c < 3; ++c)
            component_[c] =
                Array<Real>(static_cast<std::size_t>(stride()) * rows, (3 * number + c) % 16 * component_shift_bytes);
    }

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    int stride() const { return columns_ == 0 ? 0 : stride_of<Real>(columns_); }
    Array<Real>& component(int c) { return component_[c]; }
    const Array<Real>& component(int c) const { return component_[c]; }

    Field<Real> view() { return {component_[0].data(), component_[1].data(), component_[2].data(), stride()}; }
    Field<const Real> view() const {
        return {component_[0].data(), component_[1].data(), component_[2].data(), stride()};
    }

    glm::dvec3 at(int i, int j) const {
        const auto n = static_cast<std::size_t>(j) * stride() + i;
        return {component_[0][n], component_[1][n], component_[2][n]};
    }
    void set(int i, int j, const glm::dvec3& value) {
        const auto n = static_cast<std::size_t>(j) * stride() + i;
        for (int c = 0; c < 3; ++c) component_[c][n] = static_cast<Real>(value[c]);
    }

    /// Takes over every mass of a field of the same columns and rows, in whatever precision.
    template <class Other>
    void take(const FieldBuffer<Other>& other) {
        for (int c = 0; c < 3; ++c)
            for (int j = 0; j < rows_; ++j)
                std::transform(other.component(c).begin() + static_cast<std::ptrdiff_t>(j) * other.stride(),
                               other.component(c).begin() + static_cast<std::ptrdiff_t>(j) * other.stride() + columns_,
                               component_[c].begin() + static_cast<std::ptrdiff_t>(j) * stride(),
                               [](Other value) { return static_cast<Real>(value); });
    }

private:
    // Components of a power-of-two grid would all start at the same place of the first-level cache and evict one
    // another; each starts a few cache lines further on than the one before.
    static constexpr std::size_t component_shift_bytes = 11 * row_alignment;

    int columns_ = 0, rows_ = 0;
    Array<Real> component_[3];
};

/// Position (m) and velocity (m/s) of every mass, both at the same time.
template <class Real>
struct State {
    FieldBuffer<Real> position, velocity;

    State() = default;
    State(int columns, int rows) : position(columns, rows, 0), velocity(columns, rows, 1) {}

    int columns() const { return position.columns(); }
    int rows() const { return position.rows(); }
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
