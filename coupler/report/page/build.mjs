// Makes page.html of the sources and the libraries in node_modules.
import {readFileSync, writeFileSync} from "node:fs";
import {build} from "esbuild";

const made = await build({entryPoints: ["src/main.js"], bundle: true, minify: true, format: "esm", target: "es2022", write: false,
                          charset: "utf8", legalComments: "none"});
const style = await build({stdin: {contents: '@import "uplot/dist/uPlot.min.css";\n@import "./src/style.css";', resolveDir: ".", loader: "css"},
                           bundle: true, minify: true, write: false});
const version = JSON.parse(readFileSync("node_modules/uplot/package.json")).version;
const licences = `This page contains uPlot ${version} (https://github.com/leeoniya/uPlot):\n\n${readFileSync("node_modules/uplot/LICENSE", "utf8")}`;
const parts = {LICENCES: licences.replaceAll("--", "- -"), STYLE: style.outputFiles[0].text.trim(),
               PROGRAM: made.outputFiles[0].text.trim().replaceAll("</script", "<\\/script")};
const page = readFileSync("src/page.html", "utf8").replace(/@(LICENCES|STYLE|PROGRAM)@/g, (_, name) => parts[name]);
writeFileSync(process.argv[2] ?? "page.html", page);
