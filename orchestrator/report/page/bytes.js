/** The bytes that a text of the page's data stands for: base64 of what zlib packed. */
const bytesOf = (text) => pako.inflate(Uint8Array.from(atob(text), (byte) => byte.charCodeAt(0)));
