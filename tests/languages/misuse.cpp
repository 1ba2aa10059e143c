// SPDX-License-Identifier: MIT
// What the C++ wrapper says when it is used wrongly, and what it owns. Run with AddressSanitizer, which finds what is freed too early, twice or never.
#include <cstring>
#include <functional>
#include <iostream>

#include "tdsp.hpp"

namespace {

int failures = 0;

void test(const char *name, bool passed)
{
    std::cout << (passed ? "ok cpp " : "not ok cpp ") << name << '\n';
    if (!passed) failures++;
}

/** Does it throw a tdsp::error with this status, whose what() has these words? */
bool refuses(tdsp_status status, const char *words, const std::function<void()> &call)
{
    try {
        call();
    } catch (const tdsp::error &wrong) {
        if (wrong.status() == status && std::strstr(wrong.what(), words)) return true;
        std::cerr << wrong.name() << ": " << wrong.what() << '\n';
    }
    return false;
}

const tdsp::Journey journey{1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};
const std::vector<tdsp::Disc> discs{{{0.0, 3.0}, 1.0, 0.1}, {{0.0, -3.0}, 1.0, 0.1}};

void test_questions(const tdsp::Table &table)
{
    test("an answer that there is none is told apart from a mistake", refuses(TDSP_DESTINATION_COVERED, "covered", [&] { table.arrival(61.0); }) &&
                                                                          tdsp::error(TDSP_DESTINATION_COVERED).is_answer() &&
                                                                          !tdsp::error(TDSP_INVALID_ARGUMENT).is_answer());
    test("a departure before 0 is a mistake", refuses(TDSP_INVALID_ARGUMENT, "out of its range", [&] { table.arrival(-1.0); }));
    test("a path that there is none of is refused", refuses(TDSP_DESTINATION_COVERED, "covered", [&] { table.path(61.0); }));
    test("no departures have no arrivals", table.arrivals({}).statuses.empty());
}

void test_owners(const tdsp::Table &table)
{
    tdsp::Table copy = table;
    {
        const tdsp::Table gone = tdsp::build(tdsp::Scene(journey, discs), tdsp::build_options());
        copy = gone;
    }
    test("a copy keeps the bytes of a table that is gone", copy.info().rows > 1 && copy.arrival(5.0).upper > 24.0);

    const std::vector<char> bytes(static_cast<const char *>(table.data()), static_cast<const char *>(table.data()) + table.size());
    test("a view reads the caller's bytes", tdsp::Table::view(bytes.data(), bytes.size()).arrival(5.0).upper == table.arrival(5.0).upper);
    test("no bytes are no table", refuses(TDSP_BAD_MAGIC, "not a table", [] { tdsp::Table::view(nullptr, 0); }));

    tdsp::Solver solver{tdsp::Scene(journey, discs)};
    tdsp::Solver moved = std::move(solver);
    test("a solver keeps its scene, also when it moves", moved.earliest_arrival(0.0) > 19.9 && moved.path().size() == 1);
}

void test_scenes()
{
    std::vector<tdsp::Disc> wrong = discs;
    wrong[1].radius = -1.0;
    test("a scene names the disc that is out of range", refuses(TDSP_BAD_SCENE, "disc 1: ", [&] { tdsp::Scene(journey, wrong); }));
    test("a journey without speed is refused", refuses(TDSP_BAD_SCENE, "journey: ", [] { tdsp::Scene({0.0, 0.0, {}, {}}, {}); }));
    auto options = tdsp::build_options();
    options.epsilon = 2.0;
    test("a guarantee out of its range is refused", refuses(TDSP_INVALID_ARGUMENT, "out of its range", [&] { tdsp::build(tdsp::Scene(journey, discs), options); }));
    test("departures without an end need a horizon", refuses(TDSP_NEEDS_HORIZON, "horizon", [] { tdsp::build(tdsp::Scene(journey, {}), tdsp::build_options()); }));
}

} // namespace

int main(int, char **argv)
{
    const auto table = tdsp::Table::open(argv[1]);
    test_questions(table);
    test_owners(table);
    test_scenes();
    return failures > 0;
}
