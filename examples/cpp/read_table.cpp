// SPDX-License-Identifier: MIT
// Read a table, then make one: the lines of examples/c/read_table.c, to the bit.
//
//   read_table TABLE [NEW]    NEW receives the table that is made
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <string>

#include "tdsp.hpp"

namespace {

std::string number(double value)
{
    std::uint64_t bits = 0;
    char text[48];
    std::memcpy(&bits, &value, sizeof bits);
    std::snprintf(text, sizeof text, "%.6f[%016llx]", value, static_cast<unsigned long long>(bits));
    return text;
}

std::string place(tdsp::Point point) { return "(" + number(point.x) + ", " + number(point.y) + ")"; }

void print_info(const tdsp::Table &table)
{
    const auto info = table.info();
    std::cout << info.rows << " rows, " << info.legs << " legs, " << info.length << " bytes, in " << info.length_unit << " and " << info.time_unit << '\n'
              << "departures up to " << number(info.last_departure) << ", then " << tdsp_status_name(info.last_reason) << '\n';
}

void print_arrival(const tdsp::Table &table, double departure)
{
    std::cout << "leave at " << number(departure) << ": ";
    try {
        const auto [lower, upper] = table.arrival(departure);
        std::cout << "arrive from " << number(lower) << " to " << number(upper) << '\n';
    } catch (const tdsp::error &none) {
        std::cout << none.what() << '\n';
    }
}

void print_departure(const tdsp::Table &table, double arrival)
{
    std::cout << "arrive by " << number(arrival) << ": ";
    try {
        const auto [safe, none_after] = table.departure(arrival);
        std::cout << "leave by " << number(safe) << ", none after " << number(none_after) << '\n';
    } catch (const tdsp::error &none) {
        std::cout << none.what() << '\n';
    }
}

void print_path(const tdsp::Table &table, double departure)
{
    const auto path = table.path(departure);
    std::cout << "path for " << number(departure) << ": " << path.size() << " legs\n";
    for (const auto &leg : path) {
        std::cout << "  " << (leg.kind == TDSP_LEG_LINE ? "line" : "ride") << " from " << number(leg.start_time) << " at " << place(leg.from) << " to "
                  << number(leg.end_time) << " at " << place(leg.to) << '\n';
        if (leg.kind != TDSP_LEG_LINE)
            std::cout << "    on disc " << leg.disc << ", turn " << leg.turn << ", from angle " << number(leg.angle_from) << " by " << number(leg.sweep)
                      << ", radius " << number(leg.radius_from) << " to " << number(leg.radius_to) << '\n';
    }
}

void print_batch(const tdsp::Table &table)
{
    std::vector<double> departures;
    for (int i = 0; i < 8; i++) departures.push_back(10.0 * i);
    const auto answers = table.arrivals(departures);
    for (std::size_t i = 0; i < departures.size(); i++) {
        std::cout << "batch " << i << ": " << tdsp_status_name(answers.statuses[i]);
        if (answers.statuses[i] == TDSP_OK) std::cout << ' ' << number(answers.lower[i]) << ' ' << number(answers.upper[i]);
        std::cout << '\n';
    }
}

void print_jumps(const tdsp::Table &table)
{
    for (const auto &jump : table.jumps()) {
        std::cout << "after " << number(jump.departure) << ": jump from " << number(jump.before) << " to " << number(jump.after) << '\n';
        if (jump.gap.first != TDSP_NO_DISC)
            std::cout << "  discs " << jump.gap.first << " and " << jump.gap.second << " close at " << number(jump.gap.time) << ", at "
                      << place(jump.gap.place) << '\n';
    }
}

void print_table(const tdsp::Table &table)
{
    print_info(table);
    for (double departure : {0.0, 5.0, 40.0, 61.0}) print_arrival(table, departure);
    for (double arrival : {10.0, 30.0, 1000.0}) print_departure(table, arrival);
    print_path(table, 12.0);
    for (double time : {12.0, 17.0, 22.0, 27.0, 32.0, 37.0}) std::cout << "at " << number(time) << ": " << place(table.position(12.0, time)) << '\n';
    print_batch(table);
    print_jumps(table);
}

tdsp::Table make_table()
{
    const tdsp::Scene scene({1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}}, {{{0.0, 3.0}, 1.0, 0.1}, {{0.0, -3.0}, 1.0, 0.1}});
    tdsp::Solver solver(scene);
    const double arrival = solver.earliest_arrival(9.0);
    std::cout << "made: from 9 to " << number(arrival) << "; to 33 from " << number(solver.latest_departure(33.0)) << '\n';
    auto options = tdsp::build_options();
    options.epsilon = 0.05;
    options.world.length_unit = "m";
    options.world.time_unit = "s";
    return tdsp::build(scene, options);
}

} // namespace

int main(int argc, char **argv)
{
    if (argc < 2) {
        std::cerr << "usage: read_table TABLE [NEW]\n";
        return 2;
    }
    try {
        print_table(tdsp::Table::open(argv[1]));
        const auto made = make_table();
        print_table(made);
        if (argc > 2) std::ofstream(argv[2], std::ios::binary).write(static_cast<const char *>(made.data()), static_cast<std::streamsize>(made.size()));
    } catch (const std::exception &problem) {
        std::cerr << "read_table: " << problem.what() << '\n';
        return 1;
    }
    return 0;
}
