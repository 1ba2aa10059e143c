// SPDX-License-Identifier: MIT
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.List;
import java.util.function.BooleanSupplier;
import tdsp.Point;
import tdsp.Scene;
import tdsp.Solver;
import tdsp.Table;
import tdsp.TdspException;

/** What the Java wrapper says when it is used wrongly, and what it holds on to. */
public final class Misuse {
    private static final Scene.Journey JOURNEY = new Scene.Journey(1, 0, new Point(-10, 0), new Point(10, 0));
    private static final List<Scene.Disc> DISCS = List.of(new Scene.Disc(new Point(0, 3), 1, 0.1), new Scene.Disc(new Point(0, -3), 1, 0.1));

    private static int failures;

    private Misuse() {}

    private static void test(String name, BooleanSupplier passed) {
        boolean fine = passed.getAsBoolean();
        System.out.println((fine ? "ok java " : "not ok java ") + name);
        if (!fine) failures++;
    }

    private static boolean refuses(String status, String words, Runnable call) {
        try {
            call.run();
        } catch (TdspException wrong) {
            if (wrong.statusName().equals(status) && wrong.getMessage().contains(words)) return true;
            System.err.println(wrong.statusName() + ": " + wrong.getMessage());
        }
        return false;
    }

    private static boolean throwsThis(Class<? extends Exception> kind, Runnable call) {
        try {
            call.run();
            return false;
        } catch (RuntimeException thrown) {
            return kind.isInstance(thrown);
        }
    }

    private static ByteBuffer direct(byte[] bytes) {
        return ByteBuffer.allocateDirect(bytes.length).put(bytes).flip();
    }

    private static boolean isAnswer(Table table, double departure) {
        try {
            table.arrival(departure);
            return false;
        } catch (TdspException none) {
            return none.isAnswer();
        }
    }

    private static void testQuestions(Table table) {
        test("an answer that there is none is told apart from a mistake", () -> isAnswer(table, 61) && !isAnswer(table, -1));
        test("a departure before 0 is a mistake", () -> refuses("invalid_argument", "out of its range", () -> table.arrival(-1)));
        test("a path that there is none of is refused", () -> refuses("destination_covered", "covered", () -> table.path(61)));
        ByteBuffer none = ByteBuffer.allocate(8);
        test("numbers on Java's heap are refused", () -> throwsThis(IllegalArgumentException.class, () -> table.arrivals(none, none, none, none)));
        ByteBuffer short2 = ByteBuffer.allocateDirect(16).order(ByteOrder.nativeOrder());
        ByteBuffer room = ByteBuffer.allocateDirect(8).order(ByteOrder.nativeOrder());
        test("too little room is refused", () -> throwsThis(IllegalArgumentException.class, () -> table.arrivals(short2, short2, room, short2)));
    }

    private static void testBytes() {
        test("bytes that are no table are refused", () -> refuses("bad_magic", "not a table", () -> Table.of(direct(new byte[] {1, 2, 3}))));
        test("bytes on Java's heap are refused", () -> throwsThis(IllegalArgumentException.class, () -> Table.of(ByteBuffer.allocate(10))));
    }

    private static Table made() {
        try (Scene scene = new Scene(JOURNEY, DISCS)) {
            return scene.build(Scene.Guarantee.TRAVEL, 0.05, "m", "s");
        }
    }

    /** The collector takes what is forgotten, also in the middle of questions, and nothing else. */
    private static boolean forgets() {
        double want = made().arrival(5).upper();
        for (int i = 0; i < 200; i++) {
            if (made().arrival(5).upper() != want || new Solver(new Scene(JOURNEY, DISCS)).earliestArrival(5) > want) return false;
            if (i % 50 == 0) System.gc();
        }
        return true;
    }

    private static void testOwners() {
        test("what was forgotten is freed, and what is used is not", Misuse::forgets);
        Table table = made();
        table.close();
        table.close();
        test("a closed table says so", () -> throwsThis(IllegalStateException.class, () -> table.arrival(5)));
        Scene scene = new Scene(JOURNEY, DISCS);
        Solver solver = new Solver(scene);
        solver.close();
        scene.close();
        test("a closed solver says so", () -> throwsThis(IllegalStateException.class, () -> solver.earliestArrival(5)));
        test("a closed scene says so", () -> throwsThis(IllegalStateException.class, () -> new Solver(scene)));
    }

    private static void testScenes() {
        List<Scene.Disc> wrong = List.of(DISCS.get(0), new Scene.Disc(new Point(0, 0), -1, 0));
        test("a scene names the disc that is out of range", () -> refuses("bad_scene", "disc 1: ", () -> new Scene(JOURNEY, wrong)));
        Scene empty = new Scene(JOURNEY, List.of());
        test("departures without an end need a horizon", () -> refuses("needs_horizon", "horizon", () -> empty.build(Scene.Guarantee.TRAVEL, 0.05, "", "")));
        test("a guarantee out of its range is refused", () -> refuses("invalid_argument", "out of its range", () -> empty.build(Scene.Guarantee.TRAVEL, 2, "", "")));
        test("a unit that is too long is refused", () -> refuses("invalid_argument", "", () -> empty.build(Scene.Guarantee.TRAVEL, 0.05, "a unit that is too long", "")));
    }

    public static void main(String[] arguments) throws Exception {
        try (Table table = Table.open(Path.of(arguments[0]))) {
            testQuestions(table);
        }
        testBytes();
        testOwners();
        testScenes();
        System.exit(failures > 0 ? 1 : 0);
    }
}
