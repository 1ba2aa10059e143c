// SPDX-License-Identifier: MIT
/** What went wrong, for people and for programs. */
export class CoreError extends Error {
    /**
     * @param {string} message a sentence for people; begins with the place, where there is one
     * @param {string} status the library's stable name: "bad_scene", "no_memory", ...
     * @param {string} [where] the place in the description: "discs[3].radius"
     */
    constructor(message, status, where) {
        super(message);
        this.name = "CoreError";
        this.status = status;
        this.where = where;
    }
}

/**
 * An error about a place in a description, in the command's words.
 * @param {string} where
 * @param {string} reason
 */
export function sceneError(where, reason) {
    return new CoreError(where ? `${where}: ${reason}` : reason, "bad_scene", where || undefined);
}
