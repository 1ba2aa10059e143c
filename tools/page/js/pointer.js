// SPDX-License-Identifier: MIT
/** Where a mouse, a pen or a finger is within an element: pixels from its upper left corner. @param {Element} element @param {MouseEvent} event @returns {[number, number]} */
export function placeWithin(element, event) {
    const box = element.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
}
