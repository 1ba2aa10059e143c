/* SPDX-License-Identifier: MIT */
/*
 * Finding the row of a departure: the library beside the ways in which one would search a sorted array oneself.
 *     lookup_peers [REPEATS [ROWS...]]       CSV on standard output: rows,kind,queries,ns_median,ns_low,ns_high
 *
 * The question is the same for all: the first of n sorted numbers that is not below t. The peers search an array of doubles in
 * memory, inlined into the loop that asks; the library is called through its public functions, in the static library, on the bytes
 * of a table file, and checks its arguments. tdsp_find answers what the peers answer; tdsp_arrival adds the certified interval;
 * tdsp_departure is the other direction, two bounds for an arrival (its array for the peers would be that of the arrivals).
 *
 *   independent   the next question is known before the answer: look-ups overlap (throughput)
 *   dependent     it waits for the answer (latency)
 *   batch         one call for all questions, answers into an array
 *
 * All methods answer the same random questions, and are compared with std::lower_bound first. Times are nanoseconds a question: median
 * and quartiles of REPEATS rounds (default 15) after one to warm up; the methods take turns, so that a machine that drifts
 * drifts for all.
 */
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

extern "C" {
#include "build/writer.h"
#include "tdsp/table.h"
}

namespace
{

constexpr std::size_t QUESTIONS = 1 << 16;
/* Zero, but the compiler does not know: what makes a question wait for an answer. */
volatile std::uint64_t hidden_zero = 0;

void require(bool holds, const char *what)
{
    if (holds) return;
    std::fprintf(stderr, "lookup_peers: %s\n", what);
    std::exit(1);
}

std::uint64_t bits_of(double x)
{
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return bits;
}

/* ------------------------------------------------------------------------------------------------------- the numbers */

/* n departures from 0, uniformly at random in order, as many questions among them, and all that the peers keep. */
struct world {
    std::size_t n;
    std::vector<double> b;
    std::vector<double> questions;
    std::vector<double> arrivals; /* questions for the other direction */
    std::vector<double> tree;     /* Eytzinger: breadth first, from 1 */
    std::vector<std::uint32_t> tree_row;
    std::vector<std::uint32_t> cells[3]; /* guides: the first row of each cell, 1, 2 and 4 cells a row */
    double cells_per_time[3];
    void *bytes = nullptr;
    std::size_t length = 0;
    tdsp_table table{};

    explicit world(std::size_t rows);
    ~world()
    {
        tdsp_bytes_free(nullptr, bytes, length);
    }
    world(const world &) = delete;
    world &operator=(const world &) = delete;

  private:
    std::size_t fill_tree(std::size_t row, std::size_t node);
    void fill_cells(unsigned which);
    void write_table();
};

std::size_t world::fill_tree(std::size_t row, std::size_t node)
{
    if (node > n) return row;
    row = fill_tree(row, 2 * node);
    tree[node] = b[row];
    tree_row[node] = static_cast<std::uint32_t>(row);
    return fill_tree(row + 1, 2 * node + 1);
}

void world::fill_cells(unsigned which)
{
    std::size_t a_row = std::size_t{1} << which, row = 0;
    cells_per_time[which] = static_cast<double>(a_row * n) / b[n - 1];
    cells[which].resize(a_row * n + 2);
    for (std::size_t cell = 0; cell < cells[which].size(); cell++) {
        while (row < n && static_cast<std::size_t>(b[row] * cells_per_time[which]) < cell) row++;
        cells[which][cell] = static_cast<std::uint32_t>(row);
    }
}

/* Travel times that rise slowly: what a table looks like between two jumps. */
void world::write_table()
{
    const double infinity = std::numeric_limits<double>::infinity();
    writer *w = nullptr;
    writer_header header{};
    header.guarantee = TDSP_GUARANTEE_ABSOLUTE;
    header.delta = 1;
    header.first_lower = 10;
    header.last_reason = TDSP_CUT_OFF;
    require(writer_create(nullptr, &w) == TDSP_OK, "no memory");
    for (std::size_t i = 0; i < n; i++) {
        writer_row row{};
        row.departure = b[i];
        row.left = 10 + 0.1 * b[i];
        row.right = i + 1 < n ? row.left : infinity;
        require(writer_add(w, &row) == TDSP_OK, "the writer refused a row");
    }
    require(writer_finish(w, &header, &bytes, &length) == TDSP_OK, "the writer refused the table");
    writer_free(w);
    require(tdsp_table_open(&table, bytes, length) == TDSP_OK, "the table does not open");
}

world::world(std::size_t rows) : n(rows), b(rows), questions(QUESTIONS), arrivals(QUESTIONS), tree(rows + 1), tree_row(rows + 1)
{
    std::mt19937_64 chance(42);
    std::uniform_real_distribution<double> share(0, 1000);
    for (std::size_t i = 1; i < n; i++) b[i] = share(chance);
    b[0] = 0;
    std::sort(b.begin(), b.end());
    require(std::adjacent_find(b.begin(), b.end()) == b.end(), "two departures are the same");
    for (std::size_t i = 0; i < QUESTIONS; i++) {
        questions[i] = b[n - 1] * share(chance) / 1000;
        arrivals[i] = 10 + 1.1 * questions[i];
    }
    fill_tree(0, 1);
    tree_row[0] = static_cast<std::uint32_t>(n);
    for (unsigned which = 0; which < 3; which++) fill_cells(which);
    write_table();
}

/* --------------------------------------------------------------------------------------------------------- the peers */

int compare_range(const void *key, const void *element)
{
    double x = *static_cast<const double *>(key);
    const double *end = static_cast<const double *>(element);
    return x <= end[0] ? -1 : x > end[1] ? 1 : 0;
}

/* The element is the half-open range (b_i, b_(i+1)]; row 0 stands before the first. */
struct c_bsearch {
    static constexpr const char *name = "bsearch";
    static std::size_t find(const world &w, double x)
    {
        const void *at = std::bsearch(&x, w.b.data(), w.n - 1, sizeof(double), compare_range);
        return at ? static_cast<std::size_t>(static_cast<const double *>(at) - w.b.data()) + 1 : 0;
    }
};

struct std_lower_bound {
    static constexpr const char *name = "std_lower_bound";
    static std::size_t find(const world &w, double x)
    {
        return static_cast<std::size_t>(std::lower_bound(w.b.begin(), w.b.end(), x) - w.b.begin());
    }
};

struct branchless {
    static constexpr const char *name = "branchless";
    static std::size_t find(const world &w, double x)
    {
        const double *p = w.b.data();
        std::size_t n = w.n;
        while (n > 1) {
            std::size_t half = n / 2;
            p += half & (std::size_t{0} - static_cast<std::size_t>(p[half - 1] < x)); /* not `?:`: gcc makes a branch of it */
            n -= half;
        }
        return static_cast<std::size_t>(p - w.b.data()) + (*p < x ? 1 : 0);
    }
};

/* By multiplication, which compilers do not turn back into a branch, and with both next places fetched. */
struct branchless_prefetch {
    static constexpr const char *name = "branchless_prefetch";
    static std::size_t find(const world &w, double x)
    {
        const double *p = w.b.data();
        std::size_t n = w.n;
        while (n > 1) {
            std::size_t half = n / 2;
            n -= half;
            __builtin_prefetch(p + n / 2 - 1);
            __builtin_prefetch(p + half + n / 2 - 1);
            p += static_cast<std::size_t>(p[half - 1] < x) * half;
        }
        return static_cast<std::size_t>(p - w.b.data()) + (*p < x ? 1 : 0);
    }
};

struct eytzinger {
    static constexpr const char *name = "eytzinger";
    static std::size_t find(const world &w, double x)
    {
        const double *tree = w.tree.data();
        std::size_t node = 1;
        while (node <= w.n) {
            __builtin_prefetch(tree + 8 * node);
            node = 2 * node + (tree[node] < x ? 1 : 0);
        }
        node >>= __builtin_ffsll(static_cast<long long>(~node));
        return w.tree_row[node];
    }
};

template <unsigned Which> struct guide {
    static constexpr const char *name = Which == 0 ? "guide_1" : Which == 1 ? "guide_2" : "guide_4";
    static std::size_t find(const world &w, double x)
    {
        std::size_t row = w.cells[Which][static_cast<std::size_t>(x * w.cells_per_time[Which])];
        while (row < w.n && w.b[row] < x) row++;
        return row;
    }
};

/* ------------------------------------------------------------------------------------------------------- the library */

struct tdsp_find {
    static constexpr const char *name = "tdsp_find";
    static std::size_t find(const world &w, double x)
    {
        std::uint64_t row = w.n;
        return tdsp_table_find(&w.table, x, &row) == TDSP_OK ? static_cast<std::size_t>(row) : w.n;
    }
};

/* ------------------------------------------------------------------------------------------------------------ timing */

struct method {
    std::string kind;
    const char *queries;
    std::function<std::uint64_t(const world &)> run; /* asks all questions once */
};

template <class Method> std::uint64_t ask_independent(const world &w)
{
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < QUESTIONS; i++) sum += Method::find(w, w.questions[i]);
    return sum;
}

template <class Method> std::uint64_t ask_dependent(const world &w)
{
    std::uint64_t zero = hidden_zero, sum = 0;
    std::size_t row = 0;
    for (std::size_t i = 0; i < QUESTIONS; i++) {
        row = Method::find(w, w.questions[i + (row & zero)]);
        sum += row;
    }
    return sum;
}

std::vector<std::uint32_t> rows_out(QUESTIONS);

template <class Method> std::uint64_t ask_batch(const world &w)
{
    for (std::size_t i = 0; i < QUESTIONS; i++) rows_out[i] = static_cast<std::uint32_t>(Method::find(w, w.questions[i]));
    return rows_out[QUESTIONS / 2];
}

/* The guide's batch at its best: the cells of a group first, then the rows they name. */
std::uint64_t ask_guide_in_groups(const world &w)
{
    constexpr std::size_t group = 32;
    std::uint32_t row[group];
    for (std::size_t i = 0; i < QUESTIONS; i += group) {
        const double *x = &w.questions[i];
        for (std::size_t j = 0; j < group; j++) {
            row[j] = static_cast<std::uint32_t>(x[j] * w.cells_per_time[1]);
            __builtin_prefetch(&w.cells[1][row[j]]);
        }
        for (std::size_t j = 0; j < group; j++) {
            row[j] = w.cells[1][row[j]];
            __builtin_prefetch(&w.b[row[j]]);
        }
        for (std::size_t j = 0; j < group; j++) {
            while (row[j] < w.n && w.b[row[j]] < x[j]) row[j]++;
            rows_out[i + j] = row[j];
        }
    }
    return rows_out[QUESTIONS / 2];
}

std::vector<std::uint64_t> long_rows_out(QUESTIONS);
std::vector<double> low_out(QUESTIONS), high_out(QUESTIONS);

/* Two bounds a question, one question at a time: `Ask` is tdsp_table_arrival or tdsp_table_departure. */
using ask_bounds = tdsp_status (*)(const tdsp_table *, double, double *, double *);

template <ask_bounds Ask> std::uint64_t bounds_independent(const world &w, const std::vector<double> &questions)
{
    double sum = 0;
    for (double x : questions) {
        double low = 0, high = 0;
        if (Ask(&w.table, x, &low, &high) == TDSP_OK) sum += high - low;
    }
    return bits_of(sum);
}

template <ask_bounds Ask> std::uint64_t bounds_dependent(const world &w, const std::vector<double> &questions)
{
    std::uint64_t zero = hidden_zero;
    double low = 0, high = 0;
    for (std::size_t i = 0; i < QUESTIONS; i++) {
        if (Ask(&w.table, questions[i + ((bits_of(low) ^ bits_of(high)) & zero)], &low, &high) != TDSP_OK) return 0;
    }
    return bits_of(low);
}

template <class Method> void add_peer(std::vector<method> &methods)
{
    methods.push_back({Method::name, "independent", ask_independent<Method>});
    methods.push_back({Method::name, "dependent", ask_dependent<Method>});
    methods.push_back({Method::name, "batch", ask_batch<Method>});
}

void add_library(std::vector<method> &methods)
{
    methods.push_back({"tdsp_find", "independent", ask_independent<tdsp_find>});
    methods.push_back({"tdsp_find", "dependent", ask_dependent<tdsp_find>});
    methods.push_back({"tdsp_find", "batch", [](const world &w) {
                           require(tdsp_table_rows(&w.table, w.questions.data(), QUESTIONS, long_rows_out.data(), nullptr) ==
                                       TDSP_OK,
                                   "no rows");
                           return long_rows_out[1];
                       }});
    methods.push_back(
        {"tdsp_arrival", "independent", [](const world &w) { return bounds_independent<tdsp_table_arrival>(w, w.questions); }});
    methods.push_back(
        {"tdsp_arrival", "dependent", [](const world &w) { return bounds_dependent<tdsp_table_arrival>(w, w.questions); }});
    methods.push_back({"tdsp_arrival", "batch", [](const world &w) {
                           require(tdsp_table_arrivals(&w.table, w.questions.data(), QUESTIONS, low_out.data(), high_out.data(),
                                                       nullptr) == TDSP_OK,
                                   "no arrivals");
                           return bits_of(low_out[1]);
                       }});
    methods.push_back({"tdsp_departure", "independent",
                       [](const world &w) { return bounds_independent<tdsp_table_departure>(w, w.arrivals); }});
    methods.push_back(
        {"tdsp_departure", "dependent", [](const world &w) { return bounds_dependent<tdsp_table_departure>(w, w.arrivals); }});
    methods.push_back({"tdsp_departure", "batch", [](const world &w) {
                           require(tdsp_table_departures(&w.table, w.arrivals.data(), QUESTIONS, low_out.data(), high_out.data(),
                                                         nullptr) == TDSP_OK,
                                   "no departures");
                           return bits_of(low_out[1]);
                       }});
}

std::vector<method> all_methods()
{
    std::vector<method> methods;
    add_peer<c_bsearch>(methods);
    add_peer<std_lower_bound>(methods);
    add_peer<branchless>(methods);
    add_peer<branchless_prefetch>(methods);
    add_peer<eytzinger>(methods);
    add_peer<guide<0>>(methods);
    add_peer<guide<1>>(methods);
    add_peer<guide<2>>(methods);
    methods.push_back({"guide_groups", "batch", ask_guide_in_groups});
    add_library(methods);
    return methods;
}

template <class Method> void check_peer(const world &w)
{
    for (double x : w.questions) require(Method::find(w, x) == std_lower_bound::find(w, x), Method::name);
    for (double x : w.b) require(Method::find(w, x) == std_lower_bound::find(w, x), Method::name);
}

void check_answers(const world &w)
{
    check_peer<c_bsearch>(w);
    check_peer<branchless>(w);
    check_peer<branchless_prefetch>(w);
    check_peer<eytzinger>(w);
    check_peer<guide<0>>(w);
    check_peer<guide<1>>(w);
    check_peer<guide<2>>(w);
    check_peer<tdsp_find>(w);
    ask_guide_in_groups(w);
    for (std::size_t i = 0; i < QUESTIONS; i++) require(rows_out[i] == std_lower_bound::find(w, w.questions[i]), "guide_groups");
    for (double x : w.arrivals) {
        double safe, last, lower, upper;
        if (tdsp_table_departure(&w.table, x, &safe, &last) != TDSP_OK) continue;
        require(tdsp_table_arrival(&w.table, safe, &lower, &upper) == TDSP_OK && upper <= x && safe <= last, "tdsp_departure");
    }
}

double time_ns(const method &m, const world &w)
{
    auto begin = std::chrono::steady_clock::now();
    volatile std::uint64_t kept = m.run(w);
    (void)kept;
    std::chrono::duration<double, std::nano> passed = std::chrono::steady_clock::now() - begin;
    return passed.count() / static_cast<double>(QUESTIONS);
}

void measure(std::size_t rows, std::size_t repeats)
{
    world w(rows);
    check_answers(w);
    std::vector<method> methods = all_methods();
    std::vector<std::vector<double>> times(methods.size());
    for (std::size_t round = 0; round <= repeats; round++) {
        for (std::size_t i = 0; i < methods.size(); i++) {
            time_ns(methods[i], w); /* its data into the caches, its branches into the predictor */
            double ns = time_ns(methods[i], w);
            if (round > 0) times[i].push_back(ns);
        }
    }
    for (std::size_t i = 0; i < methods.size(); i++) {
        std::vector<double> &t = times[i];
        std::sort(t.begin(), t.end());
        std::printf("%zu,%s,%s,%.2f,%.2f,%.2f\n", rows, methods[i].kind.c_str(), methods[i].queries, t[t.size() / 2],
                    t[t.size() / 4], t[t.size() - 1 - t.size() / 4]);
    }
    std::fflush(stdout);
}

} // namespace

int main(int argc, char **argv)
{
    auto number = [argv](int i) { return std::strtoul(argv[i], nullptr, 10); };
    std::size_t repeats = argc > 1 ? number(1) : 15;
    std::vector<std::size_t> sizes = {64, 1 << 10, 1 << 16, 1 << 20};
    if (argc > 2) sizes.clear();
    for (int i = 2; i < argc; i++) sizes.push_back(number(i));
    for (std::size_t rows : sizes) require(rows >= 4 && rows <= 1 << 24, "ROWS is a number from 4 to 2^24");
    require(repeats >= 1 && repeats <= 1000, "REPEATS is a number from 1 to 1000");
    std::printf("rows,kind,queries,ns_median,ns_low,ns_high\n");
    for (std::size_t rows : sizes) measure(rows, repeats);
    return 0;
}
