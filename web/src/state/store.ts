// SPDX-License-Identifier: MIT
// Everything the page shows, as signals. Only the modules of state/ write them.
import { computed, signal } from "@preact/signals";
import type { DisplayMesh } from "../mesh/display-mesh.ts";
import type { Context } from "../rhino/context.ts";
import type { Snapshot } from "../share/saved-record.ts";
import type { MobilityRow } from "../solver/mobility-worker.ts";
import type {
  EditSettings,
  FreedomReport,
  MeshOffset,
  NodeCounts,
  OffsetKind,
  OpenedMesh,
  ShapeReport,
  Source,
  VariationWeights,
} from "../solver/protocol.ts";
import { type Design, NO_REPORT, sourceName } from "./design.ts";
import type { History } from "./history.ts";
import { isKind, type Kind, kindOf } from "./kept-kind.ts";
import { FAIR_FLAT, type Preview } from "./planarising.ts";
import { FIRST_SAMPLE } from "./samples.ts";
import { turnsLeft } from "./turns.ts";
import { niceStep, type Unit } from "./units.ts";

/** What is running now, for the status line and Cancel. */
export interface Activity {
  readonly label: string;
  readonly step: number;
  /** Bytes of a file, while it is read. */
  readonly read?: { readonly done: number; readonly total: number };
}

/** Along the axis, or across it in the plane at right angles. "normal" is the surface's. */
export interface Lock {
  readonly axis: "x" | "y" | "z" | "normal";
  readonly plane: boolean;
}

/** A second layer. */
export interface OffsetChoice {
  /** Model units, positive outside. */
  readonly distance: number;
  /** What lies at the distance; "": the first of them that the design has. */
  readonly form: OffsetKind | "";
}

/** One that was laid out, and the mesh that it ends with. */
export interface LaidOffset extends OffsetChoice {
  readonly of: OpenedMesh | null;
}

export type ColourBy =
  | "displacement"
  | "planarity"
  | "fold"
  | "fairness"
  | "health"
  | "remake"
  | "mobility"
  | "zebra"
  | Kind
  | "none";

/** Where a mesh can move, as far as it has been measured. */
export interface Mobility {
  readonly of: OpenedMesh;
  /** That its edits had. */
  readonly settings: EditSettings;
  /** Mean of the ways of every point up and down, model units; 0 where it is not measured yet. */
  readonly ways: Float32Array;
  readonly measured: number;
  /** Where the shape can change most, of what is measured. */
  readonly best: readonly MobilityRow[];
  readonly running: boolean;
  /** Why it does not go on. */
  readonly problem: string | null;
}

/** null until someone looks. */
export const mobility = signal<Mobility | null>(null);
/** What second layer is wanted of this mesh and its designs; null for none. */
export const offsetChoice = signal<LaidOffset | null>(null);
/** That of the design shown; null without one, and while points move. */
export const offsetLayer = signal<MeshOffset | null>(null);
/** False until the page can be used. */
export const ready = signal(false);
/** True if the solver could not be loaded: the page will not get ready. */
export const stranded = signal(false);
/** Whether the design is only looked at: the page around this one says so. */
export const readOnly = signal(false);
export const displayMesh = signal<DisplayMesh | null>(null);
export const mesh = signal<OpenedMesh | null>(null);
export const history = signal<History<Design> | null>(null);
/** The design while it is being changed; equals the history's present in between. */
export const draft = signal<Design | null>(null);
export const figures = signal<ShapeReport>(NO_REPORT);
export const activity = signal<Activity | null>(null);
export const problem = signal<string | null>(null);
/** Says that designs are not kept here; null while they are. */
export const keeping = signal<string | null>(null);
/** Designs kept under a name, oldest first. */
export const snapshots = signal<readonly Snapshot[]>([]);
/** How a mesh that is not flat becomes so; whether panels keep their shape is the edit's setting. */
export const planarising = signal(FAIR_FLAT);
/** What that would give, tried out while its door is open. */
export const planariseTrial = signal<Preview>({ kind: "none" });
export const notice = signal<string | null>(null);
/** Changes to a newer version of the page; null while there is none. */
export const update = signal<(() => void) | null>(null);
/** Points chosen, the latest last. */
export const selection = signal<readonly number[]>([]);
/** The point that the pointer rests on. */
export const visited = signal<number | null>(null);
/** Holds a drag to a line or a plane; null while it is free. */
export const lock = signal<Lock | null>(null);
/** Whether drags go in steps. */
export const snapping = signal(false);
/** The step of a drag, model units; null for one that suits the mesh. */
export const snapStep = signal<number | null>(null);
/** Whether a drag in the view draws a box around points instead. */
export const boxTool = signal(false);
/** Whether the arrows at a point follow its surface instead of X, Y and Z. */
export const localArrows = signal(false);
export const unit = signal<Unit>("m");
/** How the viewport takes a picture of itself; null before it stands. */
export const takePicture = signal<(() => Promise<Blob | null>) | null>(null);
export const dimension = signal(4);
export const eigenbasis = signal(false);
/** What the next variations are found by; undefined: the core's weights. */
export const variationWeights = signal<VariationWeights | undefined>(undefined);
export const colourBy = signal<ColourBy>("displacement");
/** Counts how often what measures designs has arrived: with every new solver. */
export const measurable = signal(0);
/** Gap (model units), mm/m and mm/m beyond rounding of every panel of the last finished design. */
export const panelFigures = signal<Float32Array | null>(null);
/** Outline, shortest edge, smallest angle and whether it changed, of every panel. */
export const panelHealth = signal<Float32Array | null>(null);
/** Nodes to make again after the last finished edit. */
export const nodeCounts = signal<NodeCounts | null>(null);
/** What became of every panel since the mesh was opened: places in DAMAGES. */
export const panelDamage = signal<Uint8Array | null>(null);
/** What is wrong with every panel: places in TROUBLES. */
export const panelTroubles = signal<Float32Array | null>(null);
/** The sharpest fold of every panel with a neighbour, degrees. */
export const panelFolds = signal<Float32Array | null>(null);
/** How far panels (circular) or points (conical) are from that kind, degrees, -1 if free of it; null
 * while nobody looks. */
export const kindDefects = signal<{ readonly kind: Kind; readonly values: Float32Array } | null>(
  null,
);
/** How sharply the edit bends at every point, model units; null while nobody looks. */
export const bending = signal<Float32Array | null>(null);
/** Whether someone looks at what the edit leaves free. */
export const watchFreedom = signal(false);
/** What the points that move can still do; null while nobody looks, or if they are too many. */
export const freedom = signal<FreedomReport | null>(null);
/** The panel that the table and the view point at. */
export const selectedPanel = signal<number | null>(null);
/** What Rhino models held beside their panels, by where their meshes came from. */
export const contexts = signal<ReadonlyMap<Source, Context>>(new Map());
export const contextHidden = signal(false);
/** Shows the base instead of the design while held. */
export const showBefore = signal(false);
/** The first visit's sentence; gone after the first edit. */
export const hintVertex = signal<number | null>(null);
export const importReport = signal(false);
/** mm/m: a tolerance chosen for an edit of a mesh that does not meet it; null without one. */
export const refusedTolerance = signal<number | null>(null);

/** The point chosen last. */
export const selected = computed(() => selection.value.at(-1) ?? null);
/** The step of a drag, model units: about a tenth of an edge where none was chosen. */
export const snapDistance = computed(
  () => snapStep.value ?? niceStep((mesh.value?.report.meanEdge ?? 1) / 10),
);
export const designName = computed(() =>
  draft.value ? sourceName(draft.value.source) : FIRST_SAMPLE.label,
);
/** What lies beside the panels of the mesh that is open; undefined for nothing. */
export const context = computed(() => draft.value && contexts.value.get(draft.value.source));
export const handles = computed(() => draft.value?.handles ?? []);
export const settings = computed(() => draft.value?.settings ?? null);
/** Whether every panel of the opened mesh is flat up to the tolerance: only then do points move. */
export const baseFlat = computed(
  () => (mesh.value?.report.worstExcess ?? 0) <= (settings.value?.tolerance ?? 0),
);
/** Whether limits are stated for the panels of an edit. */
export const limited = computed(() => (settings.value?.limits.length ?? 0) > 0);
/** The kind of constraint whose measure is shown: that of the colours, or the first that is kept. */
export const shownKind = computed((): Kind | null => {
  const colour = colourBy.value;
  if (isKind(colour)) return colour;
  const kept = settings.value?.constraints[0];
  return (kept ? kindOf(kept) : null) ?? null;
});
export const canUndo = computed(() => (history.value?.past.length ?? 0) > 0);
export const canRedo = computed(() => (history.value?.future.length ?? 0) > 0);
export const busy = computed(() => activity.value !== null || turnsLeft.value > 0);
