/* SPDX-License-Identifier: MIT */
/*
 * What look-ups cost on the processor it runs on, and what they answer: `budget.py` runs it on this machine and on Cortex-Ms in qemu.
 *
 * Answers are printed as bits, and must be the same everywhere.
 *
 * On a Cortex-M instructions are counted by SysTick: qemu runs with -icount shift=0, an instruction a nanosecond, and SysTick counts at
 * 25 MHz, so that REPEATS look-ups are told apart from one more instruction each. A call of a function that does nothing is taken off. The stack is
 * painted from below the caller's frame down, and looked at afterwards: it holds also what the C library and the compiler's arithmetic took.
 */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "tdsp/path.h"
#include "tdsp/table.h"

extern const unsigned char route[];
extern const size_t route_length;

#define QUESTIONS 64 /* departures, each with some places on its path */
#define PLACES 8

static tdsp_table table;
static double last;

static uint64_t bits(double x)
{
    uint64_t out;
    memcpy(&out, &x, sizeof out);
    return out;
}

static uint32_t bits_float(float x)
{
    uint32_t out;
    memcpy(&out, &x, sizeof out);
    return out;
}

/* Spread over the table, exactly representable as floats, some past the last departure. */
static double departure_of(int i)
{
    return (double)(float)(last * 1.02 * i / (QUESTIONS - 1));
}

static void say_arrival(double departure)
{
    double lower = 0, upper = 0;
    float least = 0, most = 0;
    tdsp_status status = tdsp_table_arrival(&table, departure, &lower, &upper);
    tdsp_status same = tdsp_table_arrival_float(&table, (float)departure, &least, &most);
    printf("arrival %016" PRIx64 " %d %016" PRIx64 " %016" PRIx64 " floats %d %08" PRIx32 " %08" PRIx32 "\n", bits(departure), (int)status, bits(lower),
           bits(upper), (int)same, bits_float(least), bits_float(most));
}

static void say_departure(double arrival)
{
    double departure = 0, none = 0;
    tdsp_status status = tdsp_table_departure(&table, arrival, &departure, &none);
    printf("departure %016" PRIx64 " %d %016" PRIx64 " %016" PRIx64 "\n", bits(arrival), (int)status, bits(departure), bits(none));
}

static void say_places(double departure)
{
    double arrival;
    if (tdsp_table_arrival(&table, departure, NULL, &arrival) != TDSP_OK) return;
    say_departure(arrival);
    for (int k = 0; k <= PLACES; k++) {
        tdsp_point at = {0, 0};
        tdsp_table_position(&table, departure, departure + (arrival - departure) * k / PLACES, &at);
        printf("place %016" PRIx64 " %016" PRIx64 "\n", bits(at.x), bits(at.y));
    }
}

#if defined(__arm__) && !defined(__linux__)

#define SYSTICK ((volatile uint32_t *)0xe000e010u) /* control, reload, value */
#define SYSTICK_MASK 0xffffffu
#define TICK 40 /* instructions */
#define REPEATS 80
#define PAINT_WORDS 512
#define PAINT UINT32_C(0xa5c3965a)

typedef void measured(double departure);

/* Results go where no frame holds them, so that the stack measured is the reader's. */
static double low, high;
static float low_float, high_float;
static tdsp_point place;
static tdsp_table view;

static void nothing(double departure)
{
    (void)departure;
    __asm__ volatile("");
}

static void arrival(double departure)
{
    tdsp_table_arrival(&table, departure, &low, &high);
}

/* A float's double without rounding: what is measured begins with the float. */
static float narrowed(double departure)
{
    uint64_t wide = bits(departure);
    uint32_t narrow = wide >> 52 == 0 ? 0 : (uint32_t)(wide >> 29) - (UINT32_C(896) << 23);
    float single;
    memcpy(&single, &narrow, sizeof single);
    return single;
}

static void nothing_float(double departure)
{
    low_float = narrowed(departure);
}

static void arrival_float(double departure)
{
    tdsp_table_arrival_float(&table, narrowed(departure), &low_float, &high_float);
}

static void position(double departure)
{
    tdsp_table_position(&table, departure, low, &place);
}

static void departure_back(double arrival)
{
    tdsp_table_departure(&table, arrival, &low, &high);
}

static void open_again(double departure)
{
    (void)departure;
    tdsp_table_reopen(&view, route, route_length);
}

static void open_whole(double departure)
{
    (void)departure;
    tdsp_table_open(&view, route, route_length);
}

static uint32_t ticks(measured *what, double departure, int repeats)
{
    SYSTICK[0] = 0;
    SYSTICK[1] = SYSTICK_MASK;
    SYSTICK[2] = 0;
    SYSTICK[0] = 5; /* the processor's clock, no interrupt */
    while (SYSTICK[2] == 0) continue;
    uint32_t begin = SYSTICK[2];
    for (int i = 0; i < repeats; i++) what(departure);
    return begin - SYSTICK[2];
}

static uint32_t instructions(measured *what, measured *without, double departure, int repeats)
{
    uint32_t all = ticks(what, departure, repeats), besides = ticks(without, departure, repeats);
    return (uint32_t)((uint64_t)(all - besides) * TICK / (uint32_t)repeats);
}

/* The most and the mean over the departures of the table. */
static void say_instructions(const char *name, measured *what, measured *without, double end, int repeats)
{
    uint32_t most = 0, sum = 0;
    for (int i = 0; i < QUESTIONS; i++) {
        uint32_t count = instructions(what, without, (double)(float)(end * i / QUESTIONS), repeats);
        most = count > most ? count : most;
        sum += count;
    }
    printf("instructions %s most %" PRIu32 " mean %" PRIu32 "\n", name, most, sum / QUESTIONS);
}

/* Words at the lower end of what is painted that nobody wrote to. */
static uint32_t untouched(const volatile uint32_t *from)
{
    uint32_t count = 0;
    while (count < PAINT_WORDS && from[count] == PAINT) count++;
    return count;
}

/* The bytes below this frame that a call used. Its own frame is above: what is painted starts where a called function's does. */
__attribute__((noinline)) static uint32_t stack_of(measured *what, double departure)
{
    volatile uint32_t *top;
    __asm__ volatile("mov %0, sp" : "=r"(top));
    volatile uint32_t *from = top - PAINT_WORDS;
    for (uint32_t i = 0; i < PAINT_WORDS; i++) from[i] = PAINT;
    what(departure);
    return 4 * (PAINT_WORDS - untouched(from));
}

static void say_stack(const char *name, measured *what, double end)
{
    uint32_t most = 0;
    for (int i = 0; i < QUESTIONS; i++) {
        uint32_t bytes = stack_of(what, (double)(float)(end * i / QUESTIONS));
        most = bytes > most ? bytes : most;
    }
    printf("stack %s %" PRIu32 "\n", name, most);
}

/* Places of every path at a few of its times. */
static void measure_positions(void)
{
    uint32_t most = 0, sum = 0, stack = 0;
    for (int i = 0; i < QUESTIONS; i++) {
        double departure = (double)(float)(last * i / QUESTIONS), arrives = 0;
        tdsp_table_arrival(&table, departure, NULL, &arrives);
        low = departure + (arrives - departure) * (double)(2 * (i % PLACES) + 1) / (2 * PLACES);
        uint32_t count = instructions(position, nothing, departure, 20), bytes = stack_of(position, departure);
        most = count > most ? count : most;
        stack = bytes > stack ? bytes : stack;
        sum += count;
    }
    printf("instructions position most %" PRIu32 " mean %" PRIu32 "\nstack position %" PRIu32 "\n", most, sum / QUESTIONS, stack);
}

static void measure(void)
{
    double arrives = 0;
    tdsp_table_arrival(&table, last, NULL, &arrives);
    say_instructions("arrival", arrival, nothing, last, REPEATS);
    say_instructions("arrival_float", arrival_float, nothing_float, last, REPEATS);
    say_instructions("departure", departure_back, nothing, arrives, REPEATS);
    say_instructions("reopen", open_again, nothing, 0, REPEATS);
    printf("instructions open most %" PRIu32 "\n", instructions(open_whole, nothing, 0, 1));
    measure_positions();
    say_stack("arrival", arrival, last);
    say_stack("arrival_float", arrival_float, last);
    say_stack("departure", departure_back, arrives);
    say_stack("reopen", open_again, 0);
    say_stack("open", open_whole, 0);
}

#else

static void measure(void)
{
}

#endif

int main(void)
{
    tdsp_table_info info;
    if (tdsp_table_open(&table, route, route_length) != TDSP_OK || tdsp_table_get_info(&table, &info) != TDSP_OK) return 1;
    last = info.last_departure;
    printf("rows %" PRIu64 " legs %" PRIu64 " curves %" PRIu64 " bytes %" PRIu64 "\n", info.rows, info.legs, info.curves, info.length);
    for (int i = 0; i < QUESTIONS; i++) say_arrival(departure_of(i));
    for (int i = 0; i < QUESTIONS; i += 4) say_places(departure_of(i));
    measure();
    return 0;
}
