"use strict";
// The page around the panel: filter, claims by their address, theme, copying, printing.
{
  const byId = (id) => document.getElementById(id);
  const all = (selector) => [...document.querySelectorAll(selector)];
  const rows = all(".verdicts tbody tr");
  const sections = new Map(all("details.claim").map((section) => [section.dataset.claim, section]));

  // The filter hides rows of the table, and the sections of the same claims.
  const filter = () => {
    const chosen = ["status", "severity", "scope"].map((id) => [id, byId(id).value]);
    const words = byId("search").value.toLowerCase().split(/\s+/).filter(Boolean);
    let shown = 0;
    for (const row of rows) {
      const { claim, text } = row.dataset;
      const fits = chosen.every(([id, value]) => !value || row.dataset[id] === value)
        && words.every((word) => text.includes(word));
      row.hidden = !fits;
      sections.get(claim).hidden = !fits;
      shown += fits ? 1 : 0;
    }
    byId("count").textContent = `${shown} of ${rows.length} claims`;
    byId("none").hidden = shown > 0;
  };
  for (const id of ["search", "status", "severity", "scope"]) byId(id).addEventListener("input", filter);
  byId("filter").addEventListener("submit", (event) => event.preventDefault());
  byId("filter").addEventListener("reset", () => setTimeout(filter));

  // #ID opens the claim (so does #claim=ID, of older pages), #panel=… sets the panel.
  const follow = () => {
    const hash = location.hash.slice(1);
    const section = sections.get(decodeURIComponent(hash.replace(/^claim=/, "")));
    if (section) {
      if (section.hidden) {
        byId("filter").reset();
        for (const id of ["search", "status", "severity", "scope"]) byId(id).value = "";
        filter();
      }
      section.open = true;
      section.scrollIntoView();
      section.querySelector("summary").focus({ preventScroll: true });
    } else if (hash.startsWith("panel=")) {
      panel.restore(hash);
      byId("panel").scrollIntoView();
    }
  };
  addEventListener("hashchange", follow);
  for (const section of sections.values()) {
    section.querySelector("summary").addEventListener("click", () => {
      if (!section.open) history.replaceState(null, "", `#${section.dataset.claim}`);
    });
  }
  const every = (open) => sections.forEach((section) => { section.open = open; });
  byId("open-all").addEventListener("click", () => every(true));
  byId("close-all").addEventListener("click", () => every(false));

  // Dark or light: as the system has it, until somebody chooses.
  const system = matchMedia("(prefers-color-scheme: dark)");
  const theme = byId("theme");
  const dark = () => (document.documentElement.dataset.theme ?? (system.matches ? "dark" : "light")) === "dark";
  const label = () => theme.setAttribute("aria-pressed", String(dark()));
  theme.addEventListener("click", () => {
    document.documentElement.dataset.theme = dark() ? "light" : "dark";
    label();
  });
  system.addEventListener("change", label);
  label();

  // Copying needs no permission, and works from a file too.
  document.addEventListener("click", async (event) => {
    const button = event.target.closest(".copy");
    if (!button) return;
    const text = button.dataset.copy ?? button.previousElementSibling.textContent;
    try {
      await navigator.clipboard.writeText(text);
      button.textContent = "Copied";
    } catch {
      getSelection().selectAllChildren(button.previousElementSibling);
      button.textContent = "Selected";
    }
    setTimeout(() => { button.textContent = "Copy"; }, 1500);
  });

  // In print everything is open; afterwards what was closed is closed again.
  let opened = [];
  addEventListener("beforeprint", () => {
    opened = all("details:not([open])").filter((details) => !details.matches(".plain"));
    for (const details of opened) details.open = true;
  });
  addEventListener("afterprint", () => opened.forEach((details) => { details.open = false; }));

  panel.start();
  follow();
}
