/* SPDX-License-Identifier: MIT */
/*
 * From reset to main() on a Cortex-M: what every firmware has, here for the boards that qemu-system-arm plays (mps2-an385, an386, an500).
 *
 * The processor takes the stack pointer and the first instruction from the vectors at address 0. Where it has an FPU that is off until
 * it is switched on, and an instruction that uses it before is a fault.
 */
#include <stdint.h>
#include <stdlib.h>

typedef void startup_handler(void);

/* From firmware.ld. */
extern uint32_t firmware_data_start[], firmware_data_end[], firmware_bss_start[], firmware_bss_end[], firmware_stack_top[];
extern const uint32_t firmware_data_load[];

extern int main(void);
/* The C library's, for a program that talks to its debugger ("semihosting"): qemu prints what it says. */
extern void initialise_monitor_handles(void);
void startup_reset(void);
void startup_fault(void);

typedef union startup_vector {
    uint32_t *stack;
    startup_handler *handler;
} startup_vector;

__attribute__((section(".vectors"), used)) static const startup_vector startup_vectors[16] = {
    {.stack = firmware_stack_top},     {.handler = startup_reset}, {.handler = startup_fault}, {.handler = startup_fault},
    {.handler = startup_fault},        {.handler = startup_fault}, {.handler = startup_fault}, {.handler = startup_fault},
    {.handler = startup_fault},        {.handler = startup_fault}, {.handler = startup_fault}, {.handler = startup_fault},
    {.handler = startup_fault},        {.handler = startup_fault}, {.handler = startup_fault}, {.handler = startup_fault}};

#define STARTUP_CPACR ((volatile uint32_t *)0xe000ed88u) /* who may use the coprocessors; the FPU is numbers 10 and 11 */

static void startup_enable_fpu(void)
{
#if defined(__ARM_FP)
    *STARTUP_CPACR |= 0xfu << 20;
    __asm__ volatile("dsb\n\tisb" ::: "memory");
#endif
}

void startup_reset(void)
{
    startup_enable_fpu();
    const uint32_t *from = firmware_data_load;
    for (uint32_t *to = firmware_data_start; to < firmware_data_end; to++) *to = *from++;
    for (uint32_t *to = firmware_bss_start; to < firmware_bss_end; to++) *to = 0;
    initialise_monitor_handles();
    exit(main());
}

/* Real firmware would bring its motors to a halt. */
void startup_fault(void)
{
    _Exit(EXIT_FAILURE);
}
