// SPDX-License-Identifier: MIT
// Build only: the guide of docs/, and the pages that it leads to, beside the page as guide/.
import { readFileSync } from "node:fs";
import { basename, dirname, join, normalize } from "node:path/posix";
import { Marked, type Tokens } from "marked";
import type { Plugin } from "vite";

const START = "guide.md";
/** In the bar of every page. */
const BAR = [
  [START, "Guide"],
  ["formats.md", "Formats"],
  ["glossary.md", "Glossary"],
  ["command-line.md", "Command line"],
] as const;

const docs = (path: string): URL => new URL(`../docs/${path}`, import.meta.url);
const read = (path: string): string => readFileSync(docs(path), "utf8");

/** As GitHub names the headings of a page. */
const anchorOf = (heading: string): string =>
  heading
    .toLowerCase()
    .replace(/[^\p{Letter}\p{Number}\s_-]/gu, "")
    .replace(/\s/g, "-");

/** A link of the page `from`: a path within docs/, and a heading there or "". */
function targetOf(href: string, from: string): { path: string; anchor: string } {
  const [file = "", anchor = ""] = href.split("#");
  return { path: file ? normalize(join(dirname(from), file)) : from, anchor };
}

const linksOf = (path: string): readonly string[] =>
  [...read(path).matchAll(/\]\(([^)\s]+\.md)(?:#[^)]*)?\)/g)].map(
    ([, href = ""]) => targetOf(href, path).path,
  );

/** What is served: the bar, and what the guide itself links to. */
const served = (): ReadonlySet<string> =>
  new Set([
    ...BAR.map(([path]) => path),
    ...linksOf(START).filter((path) => !path.startsWith("..")),
  ]);

const nameOf = (path: string): string =>
  path === START ? "index.html" : `${basename(path, ".md")}.html`;

const bar = (current: string): string =>
  BAR.map(([path, title]) => {
    const here = path === current ? ' aria-current="page"' : "";
    return `<a href="${nameOf(path)}"${here}>${title}</a>`;
  }).join("\n");

/** Pictures that a page shows are added to `pictures`. */
function htmlOf(path: string, pages: ReadonlySet<string>, pictures: Set<string>): string {
  const marked = new Marked();
  marked.use({
    renderer: {
      heading({ tokens, depth, text }: Tokens.Heading) {
        return `<h${depth} id="${anchorOf(text)}">${this.parser.parseInline(tokens)}</h${depth}>\n`;
      },
      // A link to what is not served, the source for example, stays as its words.
      link({ href, tokens }: Tokens.Link) {
        const words = this.parser.parseInline(tokens);
        if (/^https?:/.test(href)) return `<a href="${href}">${words}</a>`;
        const { path: to, anchor } = targetOf(href, path);
        if (!pages.has(to)) return words;
        return `<a href="${nameOf(to)}${anchor && `#${anchor}`}">${words}</a>`;
      },
      image({ href, text }: Tokens.Image) {
        const picture = targetOf(href, path).path;
        pictures.add(picture);
        return `<img src="${basename(picture)}" alt="${text}">`;
      },
      code({ text }: Tokens.Code) {
        const plain = text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");
        return `<pre tabindex="0"><code>${plain}</code></pre>\n`;
      },
      table(token: Tokens.Table) {
        const cell = (tag: string, { tokens, text }: Tokens.TableCell): string => {
          const kind = text === "" ? "td" : tag; // nothing is no heading
          return `<${kind}>${this.parser.parseInline(tokens)}</${kind}>`;
        };
        const row = (tag: string, cells: readonly Tokens.TableCell[]): string =>
          `<tr>${cells.map((each) => cell(tag, each)).join("")}</tr>`;
        const rows = token.rows.map((cells) => row("td", cells)).join("\n");
        // Like lines of code, wide tables scroll by themselves, and whoever uses keys can reach them.
        return `<div class="table" tabindex="0"><table><thead>${row("th", token.header)}</thead><tbody>\n${rows}</tbody></table></div>\n`;
      },
    },
  });
  const body = marked.parse(read(path), { async: false });
  const title = /^# (.+)$/m.exec(read(path))?.[1] ?? "Guide";
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'self'; img-src 'self'; base-uri 'none'; form-action 'none'">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>${title.replaceAll("`", "")} · Planish</title>
<link rel="icon" href="../icon.svg" type="image/svg+xml">
<link rel="stylesheet" href="guide.css">
</head>
<body>
<header><nav aria-label="Guide">
<a href="../index.html">Planish</a>
${bar(path)}
</nav></header>
<main>
${body}</main>
</body>
</html>
`;
}

export function guide(): Plugin {
  return {
    name: "guide",
    apply: "build",
    generateBundle() {
      const emit = (name: string, source: string): void => {
        this.emitFile({ type: "asset", fileName: `guide/${name}`, source });
      };
      const pages = served();
      const pictures = new Set<string>();
      for (const path of pages) emit(nameOf(path), htmlOf(path, pages, pictures));
      for (const picture of pictures) emit(basename(picture), read(picture));
      emit("guide.css", readFileSync(new URL("guide.css", import.meta.url), "utf8"));
    },
  };
}
