/** The rows of a table as text, a tab between the cells. The unit in a heading stands in brackets. */
function tableText(table) {
  const cellText = (cell) => {
    const unit = cell.querySelector("small");
    const words = unit ? cell.firstChild.textContent + ` [${unit.textContent.trim()}]` : cell.textContent;
    return words.replace(" []", "").replace(/\s+/g, " ").trim();
  };
  return [...table.rows].map((row) => [...row.cells].map(cellText).join("\t")).join("\n");
}

/** A button that copies a table; where the browser allows no copying, it selects the table. */
function copyButton(table) {
  const button = element("button", {type: "button", class: "copy", "aria-label": `Copy the table: ${table.caption.textContent}`}, "Copy");
  const said = element("span", {class: "said", role: "status"});
  const select = () => {
    getSelection().selectAllChildren(table);
    said.textContent = "Selected; copy it with the keyboard.";
  };
  button.addEventListener("click", () => navigator.clipboard
    ? navigator.clipboard.writeText(tableText(table)).then(() => { said.textContent = "Copied."; }, select) : select());
  return element("p", {class: "copying"}, element("span", {}, table.caption.textContent), said, button);
}
