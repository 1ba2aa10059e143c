// SPDX-License-Identifier: MIT
package tdsp;

import com.sun.jna.Native;
import com.sun.jna.Pointer;
import com.sun.jna.Structure;
import com.sun.jna.Structure.FieldOrder;
import com.sun.jna.ptr.LongByReference;
import com.sun.jna.ptr.PointerByReference;

/**
 * The C interface, as far as this package uses it, on machines of 64 bits: size_t is a long. JNA lays structures out as C does; their members are those of
 * include/tdsp/*.h, in the same order.
 */
final class Lib {
    static final int OK = 0;
    static final int BUFFER_TOO_SMALL = 17;
    static final int NO_ANSWER = 18;
    static final int BAD_SCENE = 32;
    /** sizeof(tdsp_table), whose members are private, and sizeof(tdsp_oracle), of which none is used here. */
    static final int TABLE_SIZE = 264;
    static final int ORACLE_SIZE = 96;

    static {
        Native.register(Lib.class, "tdsp");
    }

    private Lib() {}

    @FieldOrder({"x", "y"})
    public static class CPoint extends Structure {
        public double x;
        public double y;

        Point get() {
            return new Point(x, y);
        }

        void set(Point from) {
            x = from.x();
            y = from.y();
        }
    }

    @FieldOrder({"center", "radius", "growth"})
    public static class CDisc extends Structure {
        public CPoint center;
        public double radius;
        public double growth;
    }

    @FieldOrder({"speed", "radius", "source", "destination"})
    public static class CJourney extends Structure {
        public double speed;
        public double radius;
        public CPoint source;
        public CPoint destination;
    }

    @FieldOrder({"kind", "disc", "turn", "reserved", "startTime", "endTime", "from", "to", "center", "radiusFrom", "radiusTo", "angleFrom", "sweep", "rateFrom",
        "rateTo", "bendFrom", "bendTo", "speed"})
    public static class CLeg extends Structure {
        public int kind;
        public int disc;
        public int turn;
        public int reserved;
        public double startTime;
        public double endTime;
        public CPoint from;
        public CPoint to;
        public CPoint center;
        public double radiusFrom;
        public double radiusTo;
        public double angleFrom;
        public double sweep;
        public double rateFrom;
        public double rateTo;
        public double bendFrom;
        public double bendTo;
        public double speed;

        Leg get() {
            return new Leg(Leg.Kind.values()[kind], disc, turn, startTime, endTime, from.get(), to.get(), center.get(), radiusFrom, radiusTo, angleFrom, sweep);
        }
    }

    @FieldOrder({"row", "departure", "before", "after", "first", "second", "time", "place"})
    public static class CJump extends Structure {
        public long row;
        public double departure;
        public double before;
        public double after;
        public int first;
        public int second;
        public double time;
        public CPoint place;
    }

    @FieldOrder({"departure", "left", "right", "legs"})
    public static class CRow extends Structure {
        public double departure;
        public double left;
        public double right;
        public long legs;
    }

    @FieldOrder({"versionMajor", "versionMinor", "monotone", "guarantee", "sampling", "rows", "legs", "length", "sceneHash", "epsilon", "delta", "error", "timeScale",
        "speed", "source", "destination", "firstLower", "firstDeparture", "lastDeparture", "lastReason", "lengthUnit", "timeUnit", "guideLength", "curves", "gaps"})
    public static class CInfo extends Structure {
        public short versionMajor;
        public short versionMinor;
        public int monotone;
        public int guarantee;
        public int sampling;
        public long rows;
        public long legs;
        public long length;
        public long sceneHash;
        public double epsilon;
        public double delta;
        public double error;
        public double timeScale;
        public double speed;
        public CPoint source;
        public CPoint destination;
        public double firstLower;
        public double firstDeparture;
        public double lastDeparture;
        public int lastReason;
        public byte[] lengthUnit = new byte[16];
        public byte[] timeUnit = new byte[16];
        public long guideLength;
        public long curves;
        public long gaps;
    }

    @FieldOrder({"sceneHash", "speed", "source", "destination", "lengthUnit", "timeUnit"})
    public static class CWorld extends Structure {
        public long sceneHash;
        public double speed;
        public CPoint source;
        public CPoint destination;
        public Pointer lengthUnit;
        public Pointer timeUnit;
    }

    @FieldOrder({"size", "guarantee", "sampling", "epsilon", "delta", "horizon", "maxRows", "world", "progress", "progressCtx", "runTasks", "runTasksCtx", "workers",
        "workerCount", "oracleShare"})
    public static class COptions extends Structure {
        public long size;
        public int guarantee;
        public int sampling;
        public double epsilon;
        public double delta;
        public double horizon;
        public int maxRows;
        public CWorld world;
        public Pointer progress;
        public Pointer progressCtx;
        public Pointer runTasks;
        public Pointer runTasksCtx;
        public Pointer workers;
        public long workerCount;
        public double oracleShare;
    }

    static native String tdsp_version();

    static native int tdsp_status_is_answer(int status);

    static native String tdsp_status_name(int status);

    static native String tdsp_status_text(int status);

    static native int tdsp_table_open(Pointer table, Pointer bytes, long length);

    static native int tdsp_table_get_info(Pointer table, CInfo out);

    static native int tdsp_table_row(Pointer table, long row, CRow out);

    static native int tdsp_table_arrival(Pointer table, double departure, double[] lower, double[] upper);

    static native int tdsp_table_departure(Pointer table, double arrival, double[] departure, double[] departureUpper);

    static native int tdsp_table_arrivals(Pointer table, Pointer departures, long count, Pointer lower, Pointer upper, Pointer statuses);

    static native int tdsp_table_path(Pointer table, double departure, Pointer legs, long capacity, LongByReference count);

    static native int tdsp_table_position(Pointer table, double departure, double time, CPoint out);

    static native int tdsp_table_next_jump(Pointer table, double departure, CJump out);

    static native String tdsp_journey_check(CJourney journey);

    static native String tdsp_disc_check(CDisc disc);

    static native int tdsp_scene_create(CJourney journey, Pointer discs, long count, Pointer allocator, PointerByReference out);

    static native void tdsp_scene_free(Pointer scene);

    static native long tdsp_scene_hash(Pointer scene);

    static native int tdsp_solver_create(Pointer scene, PointerByReference out);

    static native void tdsp_solver_free(Pointer solver);

    static native int tdsp_earliest_arrival(Pointer solver, double departure, double[] arrival);

    static native int tdsp_latest_departure(Pointer solver, double arrival, double[] departure, double[] arrives);

    static native int tdsp_solver_path(Pointer solver, Pointer legs, long capacity, LongByReference count);

    static native int tdsp_solver_oracle(Pointer solver, Pointer out);

    static native void tdsp_build_options_init(COptions options);

    static native int tdsp_build(Pointer oracle, COptions options, Pointer allocator, PointerByReference bytes, LongByReference length, Pointer report);

    static native void tdsp_bytes_free(Pointer allocator, Pointer bytes, long length);
}
