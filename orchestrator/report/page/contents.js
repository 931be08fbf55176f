/** A link of the contents moves to its section; the address keeps the choices. */
function startContents() {
  for (const link of document.querySelectorAll('a[href^="#"]')) link.addEventListener("click", (event) => {
    event.preventDefault();
    const section = document.querySelector(link.getAttribute("href"));
    section.scrollIntoView();
    const heading = section.querySelector("h2, h3");
    heading.tabIndex = -1;
    heading.focus({preventScroll: true});
  });
}
