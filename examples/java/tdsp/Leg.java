// SPDX-License-Identifier: MIT
package tdsp;

import com.sun.jna.Pointer;
import com.sun.jna.ptr.LongByReference;
import java.util.ArrayList;
import java.util.List;

/** One leg of a path; tdsp_leg in include/tdsp/types.h says what each member means. Those from `center` on are zero for a line. */
public record Leg(Kind kind, int disc, int turn, double startTime, double endTime, Point from, Point to, Point center, double radiusFrom, double radiusTo,
    double angleFrom, double sweep) {
    /** In the order of the library's numbers. */
    public enum Kind { LINE, ARC, CURVE }

    interface Question {
        int ask(Pointer legs, long capacity, LongByReference count);
    }

    /** Ask twice, as the library does with arrays whose length is not known: how many, then for them. */
    static List<Leg> listOf(Question question) {
        LongByReference count = new LongByReference();
        int status = question.ask(Pointer.NULL, 0, count);
        if (status != Lib.BUFFER_TOO_SMALL) TdspException.check(status);
        List<Leg> legs = new ArrayList<>();
        if (count.getValue() == 0) return legs;
        Lib.CLeg first = new Lib.CLeg();
        Lib.CLeg[] array = (Lib.CLeg[]) first.toArray(Math.toIntExact(count.getValue()));
        TdspException.check(question.ask(first.getPointer(), array.length, count));
        for (Lib.CLeg leg : array) {
            leg.read();
            legs.add(leg.get());
        }
        return legs;
    }
}
