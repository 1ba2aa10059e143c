// SPDX-License-Identifier: MIT
/*
 * libtdsp for C++17, in one header: link with -ltdsp.
 *
 * A Table shares the ownership of its bytes with its copies: copy it freely, read it in any number of threads. So does a Scene; a Solver
 * is owned by one, can be moved, and keeps its Scene's memory alive. What goes wrong, and a question that has no answer, is thrown as tdsp::error with the library's words.
 */
#ifndef TDSP_HPP
#define TDSP_HPP

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tdsp/build.h"
#include "tdsp/path.h"
#include "tdsp/scene.h"
#include "tdsp/solver.h"
#include "tdsp/table.h"

namespace tdsp {

using Point = tdsp_point;
using Disc = tdsp_disc;
using Journey = tdsp_journey;
using Leg = tdsp_leg;
using Jump = tdsp_jump;
using Path = std::vector<Leg>;

/** A status that is not TDSP_OK. what() is the library's sentence, after what was asked about where that helps. */
class error : public std::runtime_error {
public:
    explicit error(tdsp_status status) : std::runtime_error(tdsp_status_text(status)), status_(status) {}
    error(const std::string &about, tdsp_status status) : std::runtime_error(about + ": " + tdsp_status_text(status)), status_(status) {}
    error(const std::string &about, const std::string &words, tdsp_status status) : std::runtime_error(about + ": " + words), status_(status) {}

    tdsp_status status() const noexcept { return status_; }
    /** The stable name, e.g. "cut_off". */
    const char *name() const noexcept { return tdsp_status_name(status_); }
    /** Was the question understood, and this is why there is no number? Otherwise something is wrong. */
    bool is_answer() const noexcept { return tdsp_status_is_answer(status_) != 0; }

private:
    tdsp_status status_;
};

inline void check(tdsp_status status)
{
    if (status != TDSP_OK) throw error(status);
}

/** The earliest arrival is not before `lower`; a path is known that arrives at `upper` or before. */
struct Interval {
    double lower;
    double upper;
};

/** Leaving at `safe` is in time for certain; leaving after `none_after` is not. */
struct Departure {
    double safe;
    double none_after;
};

/** Answers to many departures; where a status is not TDSP_OK both ends are infinite. */
struct Intervals {
    std::vector<double> lower;
    std::vector<double> upper;
    std::vector<tdsp_status> statuses;
};

class Table {
public:
    /** Read a file and check it whole. Throws error, what() beginning with the name. */
    static Table open(const std::string &name)
    {
        std::ifstream file(name, std::ios::binary);
        auto bytes = std::make_shared<std::vector<char>>();
        char part[16384];
        if (!file) throw error(name, "cannot be opened", TDSP_FAILED);
        while (file.read(part, sizeof part) || file.gcount() > 0) bytes->insert(bytes->end(), part, part + file.gcount());
        if (file.bad()) throw error(name, "cannot be read", TDSP_FAILED);
        return Table(std::shared_ptr<const void>(bytes, bytes->data()), bytes->size(), name);
    }

    /** Over bytes that somebody owns: not copied, and kept until the last copy of the table is gone. A keeper that owns nothing is a view. */
    Table(std::shared_ptr<const void> bytes, std::size_t length, const std::string &name = "table") : bytes_(std::move(bytes)), length_(bytes_ ? length : 0)
    {
        // No bytes are no table, which is not the mistake that NULL is.
        const tdsp_status status = tdsp_table_open(&table_, bytes_ ? bytes_.get() : "", length_);
        if (status != TDSP_OK) throw error(name, status);
    }

    /** A view of bytes that the caller keeps, e.g. in flash or a mapped file. */
    static Table view(const void *bytes, std::size_t length) { return Table(std::shared_ptr<const void>(std::shared_ptr<void>(), bytes), length); }

    const void *data() const noexcept { return bytes_.get(); }
    std::size_t size() const noexcept { return length_; }

    tdsp_table_info info() const
    {
        tdsp_table_info out;
        check(tdsp_table_get_info(&table_, &out));
        return out;
    }

    Interval arrival(double departure) const
    {
        Interval out{};
        check(tdsp_table_arrival(&table_, departure, &out.lower, &out.upper));
        return out;
    }

    Departure departure(double arrival) const
    {
        Departure out{};
        check(tdsp_table_departure(&table_, arrival, &out.safe, &out.none_after));
        return out;
    }

    Path path(double departure) const
    {
        std::size_t count = 0;
        const tdsp_status status = tdsp_table_path(&table_, departure, nullptr, 0, &count);
        if (status != TDSP_BUFFER_TOO_SMALL) check(status);
        Path legs(count);
        if (count > 0) check(tdsp_table_path(&table_, departure, legs.data(), legs.size(), &count));
        return legs;
    }

    /** Where a robot that left at `departure` is at `time`, clamped to its path. */
    Point position(double departure, double time) const
    {
        Point out{};
        check(tdsp_table_position(&table_, departure, time, &out));
        return out;
    }

    Intervals arrivals(const double *departures, std::size_t count) const
    {
        Intervals out{std::vector<double>(count), std::vector<double>(count), std::vector<tdsp_status>(count)};
        if (count > 0) check(tdsp_table_arrivals(&table_, departures, count, out.lower.data(), out.upper.data(), out.statuses.data()));
        return out;
    }
    Intervals arrivals(const std::vector<double> &departures) const { return arrivals(departures.data(), departures.size()); }

    /** All jumps of the travel time, in order. */
    std::vector<Jump> jumps() const
    {
        std::vector<Jump> out;
        Jump jump;
        tdsp_row next{};
        // A jump is at a row and never at the last, so there is a row after it.
        while (tdsp_table_next_jump(&table_, next.departure, &jump) == TDSP_OK) {
            out.push_back(jump);
            check(tdsp_table_row(&table_, jump.row + 1, &next));
        }
        return out;
    }

    /** The row that answers a departure, and its path where that is bytes of an oracle: a view, for as long as the table is there. */
    std::pair<const unsigned char *, std::size_t> row_bytes(double departure) const
    {
        std::uint64_t row = 0;
        const void *bytes = nullptr;
        std::size_t length = 0;
        check(tdsp_table_find(&table_, departure, &row));
        check(tdsp_table_row_bytes(&table_, row, &bytes, &length));
        return {static_cast<const unsigned char *>(bytes), length};
    }

    const tdsp_table *raw() const noexcept { return &table_; }

private:
    std::shared_ptr<const void> bytes_;
    std::size_t length_;
    tdsp_table table_;
};

/** Discs around a journey, prepared. Never changes; any number of threads, each with a Solver of its own. */
class Scene {
public:
    Scene(const Journey &journey, const std::vector<Disc> &discs)
    {
        if (const char *wrong = tdsp_journey_check(&journey)) throw error("journey", wrong, TDSP_BAD_SCENE);
        for (std::size_t i = 0; i < discs.size(); i++)
            if (const char *wrong = tdsp_disc_check(&discs[i])) throw error("disc " + std::to_string(i), wrong, TDSP_BAD_SCENE);
        tdsp_scene *made = nullptr;
        check(tdsp_scene_create(&journey, discs.data(), discs.size(), nullptr, &made));
        scene_.reset(made, tdsp_scene_free);
    }

    std::uint64_t hash() const noexcept { return tdsp_scene_hash(scene_.get()); }
    const Journey &journey() const noexcept { return *tdsp_scene_journey(scene_.get()); }

private:
    friend class Solver;
    std::shared_ptr<tdsp_scene> scene_;
};

/** A workspace for exact questions to one scene; one thread at a time. */
class Solver {
public:
    explicit Solver(const Scene &scene) : scene_(scene)
    {
        tdsp_solver *made = nullptr;
        check(tdsp_solver_create(scene_.scene_.get(), &made));
        solver_.reset(made);
    }

    double earliest_arrival(double departure)
    {
        double out = 0.0;
        check(tdsp_earliest_arrival(solver_.get(), departure, &out));
        return out;
    }

    double latest_departure(double arrival)
    {
        double out = 0.0;
        check(tdsp_latest_departure(solver_.get(), arrival, &out, nullptr));
        return out;
    }

    /** Of the last answer. */
    Path path() const
    {
        std::size_t count = 0;
        const tdsp_status status = tdsp_solver_path(solver_.get(), nullptr, 0, &count);
        if (status != TDSP_BUFFER_TOO_SMALL) check(status);
        Path legs(count);
        if (count > 0) check(tdsp_solver_path(solver_.get(), legs.data(), legs.size(), &count));
        return legs;
    }

    /** Borrows the solver. */
    tdsp_oracle oracle()
    {
        tdsp_oracle out;
        check(tdsp_solver_oracle(solver_.get(), &out));
        return out;
    }

private:
    struct Free {
        void operator()(tdsp_solver *solver) const noexcept { tdsp_solver_free(solver); }
    };
    Scene scene_; // shares the scene's memory, which is freed after the solver
    std::unique_ptr<tdsp_solver, Free> solver_;
};

/** The options with their defaults; the members of `world` are copied when the table is built. */
inline tdsp_build_options build_options()
{
    tdsp_build_options options;
    tdsp_build_options_init(&options);
    return options;
}

/** Sample any oracle. Its callbacks are called from C: they must not throw. */
inline Table build(const tdsp_oracle &oracle, const tdsp_build_options &options)
{
    void *bytes = nullptr;
    std::size_t length = 0;
    check(tdsp_build(&oracle, &options, nullptr, &bytes, &length, nullptr));
    return Table(std::shared_ptr<const void>(bytes, [length](void *made) { tdsp_bytes_free(nullptr, made, length); }), length);
}

/** The table of a scene, which its header describes. */
inline Table build(const Scene &scene, tdsp_build_options options)
{
    Solver solver(scene);
    options.world.scene_hash = scene.hash();
    options.world.speed = scene.journey().speed;
    options.world.source = scene.journey().source;
    options.world.destination = scene.journey().destination;
    return build(solver.oracle(), options);
}

} // namespace tdsp

#endif
