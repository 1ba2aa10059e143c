// SPDX-License-Identifier: MIT
import java.io.IOException;
import java.io.PrintStream;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import tdsp.Leg;
import tdsp.Point;
import tdsp.Scene;
import tdsp.Solver;
import tdsp.Table;
import tdsp.TdspException;

/**
 * Reads a table, then makes one: the lines of examples/c/read_table.c, to the bit.
 *
 * <pre>ReadTable TABLE [NEW]    NEW receives the table that is made</pre>
 */
public final class ReadTable {
    private static final PrintStream OUT = new PrintStream(System.out, false, StandardCharsets.UTF_8);

    private ReadTable() {}

    private static String number(double value) {
        return new BigDecimal(value).setScale(6, RoundingMode.HALF_EVEN).toPlainString() + String.format("[%016x]", Double.doubleToRawLongBits(value));
    }

    private static String place(Point point) {
        return "(" + number(point.x()) + ", " + number(point.y()) + ")";
    }

    private static void printInfo(Table table) {
        Table.Info info = table.info();
        OUT.printf("%d rows, %d legs, %d bytes, in %s and %s\n", info.rows(), info.legs(), info.length(), info.lengthUnit(), info.timeUnit());
        OUT.printf("departures up to %s, then %s\n", number(info.lastDeparture()), info.lastReason());
    }

    private static void printArrival(Table table, double departure) {
        OUT.printf("leave at %s: ", number(departure));
        try {
            Table.Interval found = table.arrival(departure);
            OUT.printf("arrive from %s to %s\n", number(found.lower()), number(found.upper()));
        } catch (TdspException none) {
            OUT.printf("%s\n", none.getMessage());
        }
    }

    private static void printDeparture(Table table, double arrival) {
        OUT.printf("arrive by %s: ", number(arrival));
        try {
            Table.Departure found = table.departure(arrival);
            OUT.printf("leave by %s, none after %s\n", number(found.safe()), number(found.noneAfter()));
        } catch (TdspException none) {
            OUT.printf("%s\n", none.getMessage());
        }
    }

    private static void printPath(Table table, double departure) {
        List<Leg> path = table.path(departure);
        OUT.printf("path for %s: %d legs\n", number(departure), path.size());
        for (Leg leg : path) {
            boolean line = leg.kind() == Leg.Kind.LINE;
            OUT.printf("  %s from %s at %s to %s at %s\n", line ? "line" : "ride", number(leg.startTime()), place(leg.from()), number(leg.endTime()), place(leg.to()));
            if (!line) {
                OUT.printf("    on disc %d, turn %d, from angle %s by %s, radius %s to %s\n", leg.disc(), leg.turn(), number(leg.angleFrom()), number(leg.sweep()),
                    number(leg.radiusFrom()), number(leg.radiusTo()));
            }
        }
    }

    private static ByteBuffer numbers(int count, int size) {
        return ByteBuffer.allocateDirect(count * size).order(ByteOrder.nativeOrder());
    }

    private static void printBatch(Table table) {
        int count = 8;
        ByteBuffer departures = numbers(count, Double.BYTES);
        ByteBuffer lower = numbers(count, Double.BYTES);
        ByteBuffer upper = numbers(count, Double.BYTES);
        ByteBuffer statuses = numbers(count, Integer.BYTES);
        for (int i = 0; i < count; i++) departures.asDoubleBuffer().put(i, 10.0 * i);
        table.arrivals(departures, lower, upper, statuses);
        for (int i = 0; i < count; i++) {
            int status = statuses.asIntBuffer().get(i);
            OUT.printf("batch %d: %s", i, TdspException.nameOf(status));
            if (status == 0) OUT.printf(" %s %s", number(lower.asDoubleBuffer().get(i)), number(upper.asDoubleBuffer().get(i)));
            OUT.print('\n');
        }
    }

    private static void printJumps(Table table) {
        for (Table.Jump jump : table.jumps()) {
            OUT.printf("after %s: jump from %s to %s\n", number(jump.departure()), number(jump.before()), number(jump.after()));
            Table.Gap gap = jump.gap();
            if (gap != null) OUT.printf("  discs %d and %d close at %s, at %s\n", gap.first(), gap.second(), number(gap.time()), place(gap.place()));
        }
    }

    private static void printTable(Table table) {
        printInfo(table);
        for (double departure : new double[] {0, 5, 40, 61}) printArrival(table, departure);
        for (double arrival : new double[] {10, 30, 1000}) printDeparture(table, arrival);
        printPath(table, 12);
        for (double time : new double[] {12, 17, 22, 27, 32, 37}) OUT.printf("at %s: %s\n", number(time), place(table.position(12, time)));
        printBatch(table);
        printJumps(table);
    }

    private static Table makeTable() {
        Scene.Journey journey = new Scene.Journey(1, 0, new Point(-10, 0), new Point(10, 0));
        List<Scene.Disc> discs = List.of(new Scene.Disc(new Point(0, 3), 1, 0.1), new Scene.Disc(new Point(0, -3), 1, 0.1));
        try (Scene scene = new Scene(journey, discs); Solver solver = new Solver(scene)) {
            OUT.printf("made: from 9 to %s; to 33 from %s\n", number(solver.earliestArrival(9)), number(solver.latestDeparture(33)));
            return scene.build(Scene.Guarantee.TRAVEL, 0.05, "m", "s");
        }
    }

    private static void run(String[] arguments) throws IOException {
        try (Table table = Table.open(Path.of(arguments[0]))) {
            printTable(table);
        }
        try (Table made = makeTable()) {
            printTable(made);
            if (arguments.length < 2) return;
            try (FileChannel file = FileChannel.open(Path.of(arguments[1]), StandardOpenOption.CREATE, StandardOpenOption.TRUNCATE_EXISTING, StandardOpenOption.WRITE)) {
                ByteBuffer bytes = made.bytes();
                while (bytes.hasRemaining()) file.write(bytes);
            }
        }
    }

    public static void main(String[] arguments) {
        if (arguments.length < 1) {
            System.err.println("usage: ReadTable TABLE [NEW]");
            System.exit(2);
        }
        try {
            run(arguments);
        } catch (IOException | TdspException problem) {
            OUT.flush();
            System.err.println("ReadTable: " + problem.getMessage());
            System.exit(1);
        }
        OUT.flush();
    }
}
