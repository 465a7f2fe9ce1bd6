// Byte and row of one field belong together: pointing at one marks both and says what it is.

function explainBytes() {
  const says = document.getElementById("field");
  let marked = [];
  const explain = (index) => {
    for (const element of marked) element.classList.remove("marked");
    marked = [...document.querySelectorAll(`[data-field="${index}"]`)];
    for (const element of marked) element.classList.add("marked");
    const { name, value, meaning, offset, length } = page.table.fields[index];
    const last = offset + length - 1;
    says.textContent = "";
    html("b", {}, `${name} = ${value}`, says);
    says.append(` (${length > 1 ? `bytes ${offset} to ${last}` : `byte ${offset}`}): ${meaning}`);
  };
  const grid = document.querySelector(".hex");
  for (const element of document.querySelectorAll("[data-field]")) {
    const index = Number(element.dataset.field);
    element.addEventListener("pointerenter", () => explain(index));
    element.addEventListener("click", () => explain(index));
  }
  // The grid is one stop for the keyboard; arrows go from field to field.
  grid.tabIndex = 0;
  let at = -1;
  grid.addEventListener("keydown", (event) => {
    const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!by) return;
    event.preventDefault();
    at = Math.min(Math.max(at + by, 0), page.table.fields.length - 1);
    explain(at);
  });
}
