// SPDX-License-Identifier: MIT
// Opens from a disk as well as from a server: plain scripts, nothing fetched.
import { render } from "preact";
import "../ui/tokens.css";
import "./catalogue.css";
import { Catalogue } from "./catalogue.tsx";
import type { Table } from "./table.ts";

/** Set by designs.js, which is loaded first. */
const { planishCatalogue } = globalThis as unknown as { planishCatalogue: Table };

document.title = planishCatalogue.title;
render(<Catalogue table={planishCatalogue} />, document.getElementById("app") ?? document.body);
