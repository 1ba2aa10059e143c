// SPDX-License-Identifier: MIT
package tdsp;

import com.sun.jna.Memory;
import com.sun.jna.Pointer;
import com.sun.jna.ptr.LongByReference;
import com.sun.jna.ptr.PointerByReference;
import java.lang.ref.Cleaner;
import java.lang.ref.Reference;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** Discs around a journey, prepared. Never changes: share it among threads, each with a {@link Solver} of its own. */
public final class Scene implements AutoCloseable {
    /** A disc that covers, at time t, everything closer to its centre than radius + growth t. */
    public record Disc(Point center, double radius, double growth) {}

    /** The robot and the ends of its journey. */
    public record Journey(double speed, double radius, Point source, Point destination) {}

    /** What holds between the lower and the upper end of every answer: in the order of the library's numbers. */
    public enum Guarantee { TRAVEL, ARRIVAL, ABSOLUTE }

    private final Journey journey;
    private final Cleaner.Cleanable memory;
    private Pointer raw;

    /** The refusal says which number is out of its range. */
    public Scene(Journey journey, List<Disc> discs) {
        this.journey = journey;
        Lib.CJourney from = new Lib.CJourney();
        from.speed = journey.speed();
        from.radius = journey.radius();
        from.source.set(journey.source());
        from.destination.set(journey.destination());
        inRange("journey", Lib.tdsp_journey_check(from));
        Lib.CDisc first = new Lib.CDisc();
        PointerByReference out = new PointerByReference();
        fill(first, discs);
        TdspException.check(Lib.tdsp_scene_create(from, discs.isEmpty() ? Pointer.NULL : first.getPointer(), discs.size(), Pointer.NULL, out));
        Pointer scene = out.getValue();
        raw = scene;
        memory = Table.CLEANER.register(this, () -> Lib.tdsp_scene_free(scene));
    }

    private static void fill(Lib.CDisc first, List<Disc> discs) {
        if (discs.isEmpty()) return;
        Lib.CDisc[] array = (Lib.CDisc[]) first.toArray(discs.size());
        for (int i = 0; i < array.length; i++) {
            array[i].center.set(discs.get(i).center());
            array[i].radius = discs.get(i).radius();
            array[i].growth = discs.get(i).growth();
            inRange("disc " + i, Lib.tdsp_disc_check(array[i]));
        }
    }

    private static void inRange(String what, String wrong) {
        if (wrong != null) throw new TdspException(Lib.BAD_SCENE, wrong).about(what);
    }

    /** Close its solvers first. */
    @Override
    public void close() {
        raw = null;
        memory.clean();
    }

    Pointer raw() {
        if (raw == null) throw new IllegalStateException("the scene is closed");
        return raw;
    }

    /** The table of this scene, which its header describes. The units are at most 15 bytes of UTF-8. */
    public Table build(Guarantee guarantee, double bound, String lengthUnit, String timeUnit) {
        try (Solver solver = new Solver(this); Memory oracle = new Memory(Lib.ORACLE_SIZE); Memory length = text(lengthUnit); Memory time = text(timeUnit)) {
            TdspException.check(Lib.tdsp_solver_oracle(solver.raw(), oracle));
            Lib.COptions options = new Lib.COptions();
            Lib.tdsp_build_options_init(options);
            options.guarantee = guarantee.ordinal();
            options.epsilon = bound;
            options.delta = bound;
            options.world.sceneHash = Lib.tdsp_scene_hash(raw());
            options.world.speed = journey.speed();
            options.world.source.set(journey.source());
            options.world.destination.set(journey.destination());
            options.world.lengthUnit = length;
            options.world.timeUnit = time;
            PointerByReference bytes = new PointerByReference();
            LongByReference size = new LongByReference();
            TdspException.check(Lib.tdsp_build(oracle, options, Pointer.NULL, bytes, size, Pointer.NULL));
            return Table.made(bytes.getValue(), size.getValue());
        } finally {
            Reference.reachabilityFence(this);
        }
    }

    private static Memory text(String from) {
        byte[] bytes = from.getBytes(StandardCharsets.UTF_8);
        Memory out = new Memory(bytes.length + 1);
        out.clear();
        out.write(0, bytes, 0, bytes.length);
        return out;
    }
}
