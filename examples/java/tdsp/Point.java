// SPDX-License-Identifier: MIT
package tdsp;

/** A place, in the unit of length. */
public record Point(double x, double y) {}
