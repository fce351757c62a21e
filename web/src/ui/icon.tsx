// SPDX-License-Identifier: MIT

import local from "lucide-static/icons/axis-3d.svg?raw";
import box from "lucide-static/icons/box.svg?raw";
import camera from "lucide-static/icons/camera.svg?raw";
import help from "lucide-static/icons/circle-question-mark.svg?raw";
import download from "lucide-static/icons/download.svg?raw";
import folder from "lucide-static/icons/folder-open.svg?raw";
import lasso from "lucide-static/icons/lasso.svg?raw";
import plane from "lucide-static/icons/layers-2.svg?raw";
import snap from "lucide-static/icons/magnet.svg?raw";
import pin from "lucide-static/icons/pin.svg?raw";
import plus from "lucide-static/icons/plus.svg?raw";
import redo from "lucide-static/icons/redo-2.svg?raw";
import save from "lucide-static/icons/save.svg?raw";
import scissors from "lucide-static/icons/scissors.svg?raw";
import share from "lucide-static/icons/share-2.svg?raw";
import selectBox from "lucide-static/icons/square-dashed-mouse-pointer.svg?raw";
import undo from "lucide-static/icons/undo-2.svg?raw";
import close from "lucide-static/icons/x.svg?raw";

const ICONS = {
  box,
  camera,
  close,
  download,
  folder,
  help,
  lasso,
  local,
  pin,
  plane,
  plus,
  redo,
  save,
  scissors,
  selectBox,
  share,
  snap,
  undo,
} as const;

export type IconName = keyof typeof ICONS;

/** Decoration beside a name; the markup is ours, from the build. */
export const Drawing = ({ markup }: { markup: string }) => (
  <span class="icon" aria-hidden="true" dangerouslySetInnerHTML={{ __html: markup }} />
);

export const Icon = ({ name }: { name: IconName }) => <Drawing markup={ICONS[name]} />;
