// SPDX-License-Identifier: MIT
package tdsp;

import com.sun.jna.Pointer;
import com.sun.jna.ptr.PointerByReference;
import java.lang.ref.Cleaner;
import java.lang.ref.Reference;
import java.util.List;
import java.util.function.ToIntFunction;

/** A workspace for exact questions to one scene: one thread at a time. Where close() is forgotten the garbage collector frees it. */
public final class Solver implements AutoCloseable {
    private final Scene scene;
    private final Cleaner.Cleanable memory;
    private Pointer raw;

    public Solver(Scene scene) {
        PointerByReference out = new PointerByReference();
        TdspException.check(Lib.tdsp_solver_create(scene.raw(), out));
        Pointer solver = out.getValue();
        this.scene = scene;
        raw = solver;
        memory = Table.CLEANER.register(this, () -> {
            Lib.tdsp_solver_free(solver);
            // The scene's memory goes after the solver's.
            Reference.reachabilityFence(scene);
        });
    }

    @Override
    public void close() {
        raw = null;
        memory.clean();
    }

    Pointer raw() {
        if (raw == null) throw new IllegalStateException("the solver is closed");
        scene.raw();
        return raw;
    }

    private int status(ToIntFunction<Pointer> question) {
        try {
            return question.applyAsInt(raw());
        } finally {
            Reference.reachabilityFence(this);
        }
    }

    public double earliestArrival(double departure) {
        double[] arrival = new double[1];
        TdspException.check(status(solver -> Lib.tdsp_earliest_arrival(solver, departure, arrival)));
        return arrival[0];
    }

    public double latestDeparture(double arrival) {
        double[] departure = new double[1];
        TdspException.check(status(solver -> Lib.tdsp_latest_departure(solver, arrival, departure, null)));
        return departure[0];
    }

    /** Of the last answer. */
    public List<Leg> path() {
        return Leg.listOf((legs, capacity, count) -> status(solver -> Lib.tdsp_solver_path(solver, legs, capacity, count)));
    }
}
