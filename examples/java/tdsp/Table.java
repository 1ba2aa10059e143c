// SPDX-License-Identifier: MIT
package tdsp;

import com.sun.jna.Memory;
import com.sun.jna.Native;
import com.sun.jna.Pointer;
import com.sun.jna.ptr.LongByReference;
import java.io.EOFException;
import java.io.IOException;
import java.lang.ref.Cleaner;
import java.lang.ref.Reference;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.ToIntFunction;

/**
 * An opened table. Any number of threads may ask it, as long as none closes it.
 *
 * The library keeps a pointer into the bytes: they are outside of Java's heap, where nothing moves, and this object holds on to them. A table that was made
 * holds the library's own memory, which close() gives back, or the garbage collector where close() is forgotten.
 */
public final class Table implements AutoCloseable {
    /** The earliest arrival is not before lower; a path is known that arrives at upper or before. */
    public record Interval(double lower, double upper) {}

    /** Leaving at safe is in time for certain; leaving after noneAfter is not. */
    public record Departure(double safe, double noneAfter) {}

    /** The travel time jumps after departure; what closes there is known where gap is not null. */
    public record Jump(double departure, double before, double after, Gap gap) {}

    /** Two discs that close a gap. */
    public record Gap(int first, int second, double time, Point place) {}

    /** What the header says. */
    public record Info(long rows, long legs, long length, long sceneHash, double epsilon, double delta, double speed, Point source, Point destination,
        double lastDeparture, String lastReason, String lengthUnit, String timeUnit) {}

    static final Cleaner CLEANER = Cleaner.create();

    private final ByteBuffer bytes;
    private final Cleaner.Cleanable memory;
    private Memory raw = new Memory(Lib.TABLE_SIZE);

    /** `memory` frees the bytes, or is null where the garbage collector does. */
    private Table(ByteBuffer bytes, Cleaner.Cleanable memory) {
        if (!bytes.isDirect()) throw new IllegalArgumentException("the bytes of a table are in a direct buffer");
        this.bytes = bytes.slice();
        this.memory = memory;
        TdspException.check(Lib.tdsp_table_open(raw, Native.getDirectBufferPointer(this.bytes), this.bytes.capacity()));
    }

    /** Reads a file and checks it whole; a refusal begins with the file's name. */
    public static Table open(Path file) throws IOException {
        try (FileChannel channel = FileChannel.open(file)) {
            ByteBuffer bytes = ByteBuffer.allocateDirect(Math.toIntExact(channel.size()));
            while (bytes.hasRemaining()) {
                if (channel.read(bytes) < 0) throw new EOFException(file + ": became shorter while it was read");
            }
            return of(bytes.flip());
        } catch (TdspException refused) {
            throw refused.about(file.toString());
        }
    }

    /** Over what remains of a direct buffer, without copying: it must stay as it is. */
    public static Table of(ByteBuffer bytes) {
        return new Table(bytes, null);
    }

    /** Takes over bytes of tdsp_build(). */
    static Table made(Pointer start, long length) {
        ByteBuffer bytes = start.getByteBuffer(0, length);
        return new Table(bytes, CLEANER.register(bytes, () -> Lib.tdsp_bytes_free(Pointer.NULL, start, length)));
    }

    @Override
    public void close() {
        raw = null;
        if (memory != null) memory.clean();
    }

    /** The bytes, as they are in a file: a view, for as long as the table is open. */
    public ByteBuffer bytes() {
        if (raw == null) throw new IllegalStateException("the table is closed");
        return bytes.asReadOnlyBuffer();
    }

    /** Asks the open table; the fence keeps the bytes while C reads them. */
    private void ask(ToIntFunction<Pointer> question) {
        TdspException.check(status(question));
    }

    private int status(ToIntFunction<Pointer> question) {
        if (raw == null) throw new IllegalStateException("the table is closed");
        try {
            return question.applyAsInt(raw);
        } finally {
            Reference.reachabilityFence(this);
        }
    }

    public Info info() {
        Lib.CInfo out = new Lib.CInfo();
        ask(table -> Lib.tdsp_table_get_info(table, out));
        return new Info(out.rows, out.legs, out.length, out.sceneHash, out.epsilon, out.delta, out.speed, out.source.get(), out.destination.get(), out.lastDeparture,
            Lib.tdsp_status_name(out.lastReason), Native.toString(out.lengthUnit, "UTF-8"), Native.toString(out.timeUnit, "UTF-8"));
    }

    public Interval arrival(double departure) {
        double[] lower = new double[1];
        double[] upper = new double[1];
        ask(table -> Lib.tdsp_table_arrival(table, departure, lower, upper));
        return new Interval(lower[0], upper[0]);
    }

    public Departure departure(double arrival) {
        double[] safe = new double[1];
        double[] noneAfter = new double[1];
        ask(table -> Lib.tdsp_table_departure(table, arrival, safe, noneAfter));
        return new Departure(safe[0], noneAfter[0]);
    }

    public List<Leg> path(double departure) {
        try {
            return Leg.listOf((legs, capacity, count) -> status(table -> Lib.tdsp_table_path(table, departure, legs, capacity, count)));
        } finally {
            Reference.reachabilityFence(this);
        }
    }

    /** Where a robot that left at `departure` is at `time`, clamped to its path. */
    public Point position(double departure, double time) {
        Lib.CPoint out = new Lib.CPoint();
        ask(table -> Lib.tdsp_table_position(table, departure, time, out));
        return out.get();
    }

    /**
     * Looks up many departures at once, from direct buffers in the machine's order of bytes and into such, without copying: doubles, and statuses of 4 bytes. Where a
     * status is not 0 both ends are infinite.
     */
    public void arrivals(ByteBuffer departures, ByteBuffer lower, ByteBuffer upper, ByteBuffer statuses) {
        int count = departures.capacity() / Double.BYTES;
        Pointer from = pointer(departures, count, Double.BYTES);
        Pointer toLower = pointer(lower, count, Double.BYTES);
        Pointer toUpper = pointer(upper, count, Double.BYTES);
        Pointer toStatuses = pointer(statuses, count, Integer.BYTES);
        ask(table -> Lib.tdsp_table_arrivals(table, from, count, toLower, toUpper, toStatuses));
        Reference.reachabilityFence(new ByteBuffer[] {departures, lower, upper, statuses});
    }

    private static Pointer pointer(ByteBuffer buffer, int count, int size) {
        if (!buffer.isDirect() || buffer.order() != ByteOrder.nativeOrder() || buffer.capacity() < count * size) {
            throw new IllegalArgumentException("a direct buffer in the native order with room for " + count + " numbers is needed");
        }
        return Native.getDirectBufferPointer(buffer);
    }

    /** The jumps of the travel time, in order. */
    public List<Jump> jumps() {
        List<Jump> jumps = new ArrayList<>();
        Lib.CJump jump = new Lib.CJump();
        Lib.CRow next = new Lib.CRow();
        while (true) {
            int status = status(table -> Lib.tdsp_table_next_jump(table, next.departure, jump));
            if (status == Lib.NO_ANSWER) return jumps;
            TdspException.check(status);
            Gap gap = jump.first == -1 ? null : new Gap(jump.first, jump.second, jump.time, jump.place.get());
            jumps.add(new Jump(jump.departure, jump.before, jump.after, gap));
            // A jump is at a row and never at the last, so there is a row after it.
            ask(table -> Lib.tdsp_table_row(table, jump.row + 1, next));
        }
    }
}
