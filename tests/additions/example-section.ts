// SPDX-License-Identifier: MIT
import { h } from "preact";

/** A feature of the page: all that it has is this section. */
export const ExampleSection = () =>
  h(
    "section",
    { class: "step", "aria-labelledby": "example" },
    h("h2", { id: "example" }, "Example"),
  );
