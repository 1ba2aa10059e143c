/* Reading growth laws: what they are stands in law.h. */
#include "geom/law.h"

uint32_t law_piece_at(const geom_law *law, double time)
{
    uint32_t low = 0, high = law->count; /* pieces[low] begins in time, pieces[high] does not */
    while (high - low > 1) {
        uint32_t middle = low + (high - low) / 2;
        if (law->pieces[middle].start <= time) low = middle;
        else high = middle;
    }
    return low;
}

law_jet law_piece_jet(const law_piece *piece, double time)
{
    double u = time - piece->start;
    law_jet jet = {piece->c[piece->degree], 0.0, 0.0};
    for (uint32_t k = piece->degree; k-- > 0;) {
        jet.bend = jet.bend * u + jet.rate;
        jet.rate = jet.rate * u + jet.radius;
        jet.radius = jet.radius * u + piece->c[k];
    }
    jet.bend *= 2.0;
    return jet;
}
