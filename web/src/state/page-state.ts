// SPDX-License-Identifier: MIT
// Everything the page shows, as signals. Only the modules of state/ write them.
import { computed, signal } from "@preact/signals";
import type { NamedView } from "../design/camera.ts";
import { type Design, NO_REPORT, sourceName } from "../design/design.ts";
import type { History } from "../design/history.ts";
import { isKind, type Kind, kindOf } from "../design/kept-kind.ts";
import { FAIR_FLAT, type Preview } from "../design/planarising.ts";
import { FIRST_SAMPLE } from "../design/samples.ts";
import type { Snapshot } from "../design/saved-record.ts";
import { imagesOf } from "../design/symmetry.ts";
import type { DisplayMesh } from "../mesh/display-mesh.ts";
import { niceStep, type Unit } from "../quantity/units.ts";
import type { Context } from "../rhino/context.ts";
import type { MobilityRow } from "../solver/mobility-worker.ts";
import type {
  EditSettings,
  FreedomReport,
  MeshOffset,
  NodeCounts,
  OffsetKind,
  OpenedMesh,
  PanelTypes,
  ShapeReport,
  Source,
  VariationWeights,
} from "../solver/protocol.ts";

/** What is running now, for the status line and Cancel. */
export interface Activity {
  readonly label: string;
  readonly step: number;
  /** Bytes of a file, while it is read. */
  readonly read?: { readonly done: number; readonly total: number };
}

/** A drag as it is shown. */
export interface Pull {
  /** The point that leads. */
  readonly vertex: number;
  /** The length typed for it, as typed; "" while the pointer says how far. */
  readonly typed: string;
}

/** Along the axis, or across it in the plane at right angles. "normal" is the surface's. */
export interface Lock {
  readonly axis: "x" | "y" | "z" | "normal";
  readonly plane: boolean;
}

/** What selects points by a drag: a box, or a loop drawn by hand. */
export type AreaTool = "box" | "lasso";

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
  | "shape"
  | "slide"
  | "displacement"
  | "planarity"
  | "fold"
  | "fairness"
  | "health"
  | "remake"
  | "mobility"
  | "conjugacy"
  | "zebra"
  | "glass"
  | "types"
  | "groups"
  | Kind
  | "none";

/** How far panels of one type may be from alike. */
export interface TypesChoice {
  /** A share of the mean edge. */
  readonly share: number;
  /** A panel may be its template turned over. */
  readonly mirrored: boolean;
}

/** Which panels are alike. */
export interface ShownTypes extends TypesChoice {
  readonly of: Design;
  readonly types: PanelTypes;
}

/** Where a mesh can move, as far as it has been measured. */
export interface Mobility {
  readonly of: OpenedMesh;
  /** The settings that its edits had. */
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

/** What a page shows. */
export class PageState {
  /** null until someone looks. */
  readonly typesChoice = signal<TypesChoice>({ share: 0.005, mirrored: false });
  /** Of the latest design and choice for which they were found. */
  readonly shownTypes = signal<ShownTypes | null>(null);
  readonly mobility = signal<Mobility | null>(null);
  /** By how many degrees each panel's lines are off conjugate directions; −1: not known. */
  readonly conjugacy = signal<{ of: OpenedMesh; angles: Float32Array } | null>(null);
  /** What second layer is wanted of this mesh and its designs; null for none. */
  readonly offsetChoice = signal<LaidOffset | null>(null);
  /** The second layer of the design shown; null without one, and while points move. */
  readonly offsetLayer = signal<MeshOffset | null>(null);
  /** False until the page can be used. */
  readonly ready = signal(false);
  /** True if the solver could not be loaded: the page will not get ready. */
  readonly stranded = signal(false);
  /** Whether someone chose here how far edits reach: else that grows from drag to drag as it is needed. */
  readonly reachChosen = signal(false);
  /** Whether the tolerance is what this mesh asks for, and nobody's choice for the next one. */
  readonly toleranceTaken = signal(false);
  /** Limits that someone stated here; those of the settings beside them the page has found itself. */
  readonly statedLimits = signal<readonly string[]>([]);
  /** Whether the design is only looked at: the page around this one says so. */
  readonly readOnly = signal(false);
  readonly displayMesh = signal<DisplayMesh | null>(null);
  readonly mesh = signal<OpenedMesh | null>(null);
  readonly history = signal<History<Design> | null>(null);
  /** The design while it is being changed; equals the history's present in between. */
  readonly draft = signal<Design | null>(null);
  readonly figures = signal<ShapeReport>(NO_REPORT);
  readonly activity = signal<Activity | null>(null);
  /** How many parts of the page are being fetched; what was asked of them has not begun. */
  readonly fetching = signal(0);
  /** Points that are listed to stand on something. */
  readonly supported = signal<readonly number[]>([]);
  readonly problem = signal<string | null>(null);
  /** Says that designs are not kept here; null while they are. */
  readonly keeping = signal<string | null>(null);
  /** A change waits to be written, or is being written. */
  readonly unsaved = signal(false);
  /** Designs kept under a name, oldest first. */
  readonly snapshots = signal<readonly Snapshot[]>([]);
  /** Where the view may look from again, oldest first. */
  readonly views = signal<readonly NamedView[]>([]);
  /** How a mesh that is not flat becomes so; whether panels keep their shape is the edit's setting. */
  readonly planarising = signal(FAIR_FLAT);
  /** What that would give, tried out while its door is open. */
  readonly planariseTrial = signal<Preview>({ kind: "none" });
  readonly notice = signal<string | null>(null);
  /** Actions that run or wait and have not been dropped. */
  readonly queued = signal(0);
  /** Changes to a newer version of the page; null while there is none. */
  readonly update = signal<(() => void) | null>(null);
  /** Points chosen, the latest last. */
  readonly selection = signal<readonly number[]>([]);
  /** The point that the pointer rests on. */
  readonly visited = signal<number | null>(null);
  /** The drag that is going on; null between drags. */
  readonly pull = signal<Pull | null>(null);
  /** Holds a drag to a line or a plane; null while it is free. */
  readonly lock = signal<Lock | null>(null);
  /** The outer share of a group over which a move of it falls off; 0: all of it moves alike. */
  readonly fallOff = signal(0);
  /** Whether drags go in steps. */
  readonly snapping = signal(false);
  /** The step of a drag, model units; null for one that suits the mesh. */
  readonly snapStep = signal<number | null>(null);
  /** What a drag in the view draws around points instead; null: nothing. */
  readonly areaTool = signal<AreaTool | null>(null);
  /** Whether clicks in the view cut panels instead. */
  readonly cutting = signal(false);
  /** The field of typed moves that a key asked for, until the focus leaves it. */
  readonly typedMove = signal<"X" | "Y" | "Z" | null>(null);
  /** Whether the controls are folded away, where they are a sheet under the view. */
  readonly sheetFolded = signal(false);
  /** Whether the arrows at a point follow its surface instead of X, Y and Z. */
  readonly localArrows = signal(false);
  readonly unit = signal<Unit>("m");
  /** How the viewport takes a picture of itself; null before it stands. */
  readonly takePicture = signal<(() => Promise<Blob | null>) | null>(null);
  readonly dimension = signal(4);
  readonly eigenbasis = signal(false);
  /** What the next variations are found by; undefined: the core's weights. */
  readonly variationWeights = signal<VariationWeights | undefined>(undefined);
  readonly colourBy = signal<ColourBy>("shape");
  /** Gap (model units), mm/m and mm/m beyond rounding of every panel of the last finished design. */
  readonly panelFigures = signal<Float32Array | null>(null);
  /** Outline, shortest edge, smallest angle and whether it changed, of every panel. */
  readonly panelHealth = signal<Float32Array | null>(null);
  /** Nodes to make again after the last finished edit. */
  readonly nodeCounts = signal<NodeCounts | null>(null);
  /** What became of every panel since the mesh was opened: places in DAMAGES. */
  readonly panelDamage = signal<Uint8Array | null>(null);
  /** What is wrong with every panel: places in TROUBLES. */
  readonly panelTroubles = signal<Float32Array | null>(null);
  /** The sharpest fold of every panel with a neighbour, degrees. */
  readonly panelFolds = signal<Float32Array | null>(null);
  /** How far panels (circular) or points (conical) are from that kind, degrees, -1 if free of it; null
   * while nobody looks. */
  readonly kindDefects = signal<{ readonly kind: Kind; readonly values: Float32Array } | null>(
    null,
  );
  /** How sharply the edit bends at every point, model units; null while nobody looks. */
  readonly bending = signal<Float32Array | null>(null);
  /** Whether someone looks at what the edit leaves free. */
  readonly watchFreedom = signal(false);
  /** What the points that move can still do; null while nobody looks, or if they are too many. */
  readonly freedom = signal<FreedomReport | null>(null);
  /** The panel that the table and the view point at. */
  readonly selectedPanel = signal<number | null>(null);
  /** What Rhino models held beside their panels, by where their meshes came from. */
  readonly contexts = signal<ReadonlyMap<Source, Context>>(new Map());
  readonly contextHidden = signal(false);
  /** Shows the base instead of the design while held. */
  readonly showBefore = signal(false);
  /** The first visit's sentence; gone after the first edit. */
  readonly hintVertex = signal<number | null>(null);
  readonly importReport = signal(false);
  /** mm/m: a tolerance chosen for an edit of a mesh that does not meet it; null without one. */
  readonly refusedTolerance = signal<number | null>(null);

  /** The point chosen last. */
  readonly selected = computed(() => this.selection.value.at(-1) ?? null);
  /** The step of a drag, model units: about a tenth of an edge where none was chosen. */
  readonly snapDistance = computed(
    () => this.snapStep.value ?? niceStep((this.mesh.value?.report.meanEdge ?? 1) / 10),
  );
  readonly designName = computed(() =>
    this.draft.value ? sourceName(this.draft.value.source) : FIRST_SAMPLE.label,
  );
  /** What lies beside the panels of the mesh that is open; undefined for nothing. */
  readonly context = computed(
    () => this.draft.value && this.contexts.value.get(this.draft.value.source),
  );
  readonly handles = computed(() => this.draft.value?.handles ?? []);
  /** Points that follow the handles as their images. */
  readonly images = computed((): readonly number[] => {
    const orbits = this.mesh.value?.symmetry?.orbits;
    return orbits
      ? imagesOf(
          orbits,
          this.handles.value.map(({ vertex }) => vertex),
        )
      : [];
  });
  readonly settings = computed(() => this.draft.value?.settings ?? null);
  /** Whether every panel of the opened mesh is flat up to the tolerance: only then do points move. */
  readonly baseFlat = computed(
    () => (this.mesh.value?.report.worstExcess ?? 0) <= (this.settings.value?.tolerance ?? 0),
  );
  /** Whether limits are stated for the panels of an edit. */
  readonly limited = computed(() => (this.settings.value?.limits.length ?? 0) > 0);
  /** The kind of constraint whose measure is shown: that of the colours, or the first that is kept. */
  readonly shownKind = computed((): Kind | null => {
    const colour = this.colourBy.value;
    if (isKind(colour)) return colour;
    const kept = this.settings.value?.constraints[0];
    return (kept ? kindOf(kept) : null) ?? null;
  });
  readonly canUndo = computed(() => (this.history.value?.past.length ?? 0) > 0);
  readonly canRedo = computed(() => (this.history.value?.future.length ?? 0) > 0);
  readonly busy = computed(() => this.activity.value !== null || this.queued.value > 0);
}
