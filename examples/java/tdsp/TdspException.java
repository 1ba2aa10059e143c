// SPDX-License-Identifier: MIT
package tdsp;

/** What goes wrong, and a question that has no answer, with the library's words. */
public final class TdspException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final int status;

    TdspException(int status, String words) {
        super(words);
        this.status = status;
    }

    /** Throws unless the status is 0. */
    static void check(int status) {
        if (status != Lib.OK) throw new TdspException(status, Lib.tdsp_status_text(status));
    }

    TdspException about(String what) {
        return new TdspException(status, what + ": " + getMessage());
    }

    /** The library's number, of tdsp/status.h. */
    public int status() {
        return status;
    }

    /** The stable name, e.g. "cut_off". */
    public String statusName() {
        return Lib.tdsp_status_name(status);
    }

    /** The name of any status, also of those in arrays; "ok" for 0. */
    public static String nameOf(int status) {
        return Lib.tdsp_status_name(status);
    }

    /** Was the question understood, and this is why there is no number? */
    public boolean isAnswer() {
        return Lib.tdsp_status_is_answer(status) != 0;
    }
}
